package scenes;

import javax.vecmath.Vector3d;

import arguments.Messages;

/** Reads the placement of an object: scale, aiming, rotation and translation, which take effect in this order. */
final class PlacementReader {

  /**
   * Sine of the angle below which a main and an auxiliary vector count as parallel: eight times the rounding of a
   * direction given in floats.
   */
  private static final double PARALLEL = 0x1p-21;

  static final String[] MAIN = {"iVector", "jVector", "kVector"};
  static final String[] AUXILIARY = {"iauxVector", "jauxVector", "kauxVector"};

  private final Values values;

  PlacementReader(final Values values) {
    this.values = values;
  }

  /** The placement of an object; null if it is invalid. */
  Placement read(final Element object) {
    final int before = values.problems().errors();
    final float[] scale = triple(object, "scaleFactors", Placement.unscaled());
    final float[] shift = triple(object, "translation", Placement.unmoved());
    final Rotation rotation = rotation(object);
    final Rotation aiming = aiming(object);
    if (scale != null && (scale[0] == 0 || scale[1] == 0 || scale[2] == 0)) {
      final Element value = object.find("scaleFactors");
      values.problems().error(value.valueOffset(), "scaleZero", Messages.quote(value.text()));
    }
    return values.problems().errors() > before ? null : new Placement(scale, rotation.after(aiming), shift,
        ExactPlacement.of(object));
  }

  private float[] triple(final Element object, final String name, final float[] absent) {
    final Element value = values.optional(object, name);
    return value == null ? absent : values.triple(value, Range.ANY);
  }

  private Rotation rotation(final Element object) {
    final float degrees = values.number(object, "rotationAngle", Range.ANY, 0);
    final float[] axis = triple(object, "rotationAxis", new float[] {0, 1, 0});
    if (axis == null || Float.isNaN(degrees) || degrees == 0) {
      return Rotation.NONE;
    }
    if (axis[0] == 0 && axis[1] == 0 && axis[2] == 0) {
      nullVector(object.find("rotationAxis"));
      return Rotation.NONE;
    }
    return Rotation.about(axis, degrees);
  }

  /** The rotation of the first main vector given and the first auxiliary vector that goes with it. */
  private Rotation aiming(final Element object) {
    for (int main = 0; main < 3; main++) {
      final Element value = values.optional(object, MAIN[main]);
      if (value != null) {
        final int first = main == 0 ? 1 : 0;
        final int second = 3 - main - first;
        final boolean firstGiven = values.has(object, AUXILIARY[first]);
        final int auxiliary = firstGiven ? first : second;
        final Element auxiliaryValue = values.optional(object, AUXILIARY[auxiliary]);
        if (auxiliaryValue == null) {
          values.problems().error(value.offset(), "auxiliaryMissing", MAIN[main], AUXILIARY[first], AUXILIARY[second]);
          return Rotation.NONE;
        }
        return aimed(main, value, auxiliary, auxiliaryValue);
      }
    }
    strayAuxiliary(object);
    return Rotation.NONE;
  }

  private void strayAuxiliary(final Element object) {
    for (int n = 0; n < 3; n++) {
      final Element value = object.find(AUXILIARY[n]);
      if (value != null) {
        values.problems().warning(value.offset(), "mainMissing", AUXILIARY[n]);
      }
    }
  }

  /** The rotation that takes the main axis to its vector, and the auxiliary axis as near to its own vector as possible. */
  private Rotation aimed(final int main, final Element mainValue, final int auxiliary, final Element auxiliaryValue) {
    final Vector3d m = direction(mainValue);
    final Vector3d aux = direction(auxiliaryValue);
    if (m == null || aux == null) {
      return Rotation.NONE;
    }
    final Vector3d[] frame = frame(main, m, auxiliary, aux);
    if (frame == null) {
      values.problems().error(auxiliaryValue.valueOffset(), "parallel", auxiliaryValue.name(),
          Messages.quote(auxiliaryValue.text()), mainValue.name(), Messages.quote(mainValue.text()));
      return Rotation.NONE;
    }
    return Rotation.to(frame[0], frame[1], frame[2]);
  }

  /**
   * The images of the three axes: the one that is neither main nor auxiliary is perpendicular to both vectors, which are
   * unit vectors; the auxiliary one follows from the others. Null if the vectors are parallel.
   */
  static Vector3d[] frame(final int main, final Vector3d m, final int auxiliary, final Vector3d aux) {
    final boolean inOrder = (main + 1) % 3 == auxiliary;
    final Vector3d[] frame = new Vector3d[3];
    final Vector3d third = new Vector3d();
    third.cross(inOrder ? m : aux, inOrder ? aux : m);
    if (!(third.length() > PARALLEL)) {
      return null;
    }
    third.normalize();
    final Vector3d second = new Vector3d();
    second.cross(inOrder ? third : m, inOrder ? m : third);
    frame[main] = m;
    frame[auxiliary] = second;
    frame[3 - main - auxiliary] = third;
    return frame;
  }

  private Vector3d direction(final Element value) {
    final float[] triple = values.triple(value, Range.ANY);
    if (triple == null) {
      return null;
    }
    final Vector3d direction = new Vector3d(triple[0], triple[1], triple[2]);
    if (direction.x == 0 && direction.y == 0 && direction.z == 0) {
      nullVector(value);
      return null;
    }
    direction.normalize();
    return direction;
  }

  private void nullVector(final Element value) {
    values.problems().error(value.valueOffset(), "nullVector", value.name(), Messages.quote(value.text()));
  }
}
