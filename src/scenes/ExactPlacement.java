package scenes;

import javax.vecmath.AxisAngle4d;
import javax.vecmath.Matrix3d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;

import diagnostics.UnusualBlank;

/**
 * A placement in the precision of the file's decimal numbers, for meshes in coordinates so large that their vertices
 * would coincide in floats.
 *
 * @param scale factors along the axes of the model
 * @param rotation the rotation that follows
 * @param shift the translation that follows
 */
record ExactPlacement(Vector3d scale, Matrix3d rotation, Vector3d shift) {

  /** The placement of an object without errors. */
  static ExactPlacement of(final Element object) {
    final Matrix3d rotation = aiming(object);
    final double degrees = numbers(object, "rotationAngle", 0)[0];
    if (degrees != 0) {
      final Vector3d axis = new Vector3d(numbers(object, "rotationAxis", 0, 1, 0));
      axis.normalize();
      final Matrix3d turn = new Matrix3d();
      turn.set(new AxisAngle4d(axis.x, axis.y, axis.z, Math.toRadians(Math.IEEEremainder(degrees, 360))));
      rotation.mul(turn, rotation);
    }
    return new ExactPlacement(new Vector3d(numbers(object, "scaleFactors", 1, 1, 1)), rotation,
        new Vector3d(numbers(object, "translation", 0, 0, 0)));
  }

  /** The numbers of an element, or the defaults if it is missing. */
  private static double[] numbers(final Element object, final String name, final double... absent) {
    final Element value = object.find(name);
    if (value == null) {
      return absent;
    }
    final String[] numbers = UnusualBlank.replaced(value.text()).strip().split("\\s+");
    final double[] values = new double[Math.min(numbers.length, absent.length)];
    for (int i = 0; i < values.length; i++) {
      values[i] = Double.parseDouble(numbers[i]);
    }
    return values;
  }

  private static Matrix3d aiming(final Element object) {
    final Matrix3d rotation = new Matrix3d();
    rotation.setIdentity();
    for (int main = 0; main < 3; main++) {
      if (object.find(PlacementReader.MAIN[main]) != null) {
        final int first = main == 0 ? 1 : 0;
        final int auxiliary = object.find(PlacementReader.AUXILIARY[first]) != null ? first : 3 - main - first;
        final Vector3d m = direction(object, PlacementReader.MAIN[main]);
        final Vector3d[] frame = PlacementReader.frame(main, m, auxiliary,
            direction(object, PlacementReader.AUXILIARY[auxiliary]));
        for (int k = 0; k < 3; k++) {
          rotation.setColumn(k, frame[k]);
        }
        return rotation;
      }
    }
    return rotation;
  }

  private static Vector3d direction(final Element object, final String name) {
    final Vector3d direction = new Vector3d(numbers(object, name, 0, 0, 0));
    direction.normalize();
    return direction;
  }

  /** Where a point of the model goes. */
  Point3d applied(final Point3d p) {
    final Point3d moved = new Point3d(p.x * scale.x, p.y * scale.y, p.z * scale.z);
    rotation.transform(moved);
    moved.add(shift);
    return moved;
  }
}
