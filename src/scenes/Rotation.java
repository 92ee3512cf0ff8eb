package scenes;

import javax.vecmath.AxisAngle4d;
import javax.vecmath.Matrix3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;

/** A rotation about an axis through the origin, as a matrix and as axis and angle. */
final class Rotation {

  static final Rotation NONE = new Rotation(identity(), new Vector3f(0, 1, 0), 0);

  private final Matrix3d matrix;
  private final Vector3f axis;
  private final float degrees;

  private Rotation(final Matrix3d matrix, final Vector3f axis, final float degrees) {
    this.matrix = matrix;
    this.axis = axis;
    this.degrees = degrees;
  }

  private static Matrix3d identity() {
    final Matrix3d identity = new Matrix3d();
    identity.setIdentity();
    return identity;
  }

  /** The rotation by an angle in degrees, counter-clockwise seen from the tip of the axis, which has any length but 0. */
  static Rotation about(final float[] axis, final float degrees) {
    final double least = Math.IEEEremainder(degrees, 360);
    if (least == 0) {
      return NONE;
    }
    final double x = axis[0], y = axis[1], z = axis[2], length = Math.sqrt(x * x + y * y + z * z);
    final Matrix3d matrix = new Matrix3d();
    matrix.set(new AxisAngle4d(x / length, y / length, z / length, Math.toRadians(least)));
    final Vector3f unit = new Vector3f((float) (x / length), (float) (y / length), (float) (z / length));
    return new Rotation(matrix, unit, (float) least);
  }

  /** The rotation that takes the axes X, Y and Z to three orthonormal vectors of a right-handed frame. */
  static Rotation to(final Vector3d i, final Vector3d j, final Vector3d k) {
    return of(new Matrix3d(i.x, j.x, k.x, i.y, j.y, k.y, i.z, j.z, k.z));
  }

  /** This rotation after another. */
  Rotation after(final Rotation first) {
    if (first == NONE || this == NONE) {
      return this == NONE ? first : this;
    }
    final Matrix3d product = new Matrix3d();
    product.mul(matrix, first.matrix);
    return of(product);
  }

  /**
   * The axis and the angle of a matrix, by way of the quaternion of which the largest component is computed first
   * (Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1(3), 1978): exact to rounding for every
   * angle, where the antisymmetric part of the matrix vanishes at 0° and at 180°.
   */
  private static Rotation of(final Matrix3d m) {
    final double[] squares = {1 + m.m00 + m.m11 + m.m22, 1 + m.m00 - m.m11 - m.m22, 1 - m.m00 + m.m11 - m.m22,
        1 - m.m00 - m.m11 + m.m22};
    int largest = 0;
    for (int n = 1; n < 4; n++) {
      largest = squares[n] > squares[largest] ? n : largest;
    }
    final double[] q = switch (largest) {
      case 0 -> new double[] {squares[0], m.m21 - m.m12, m.m02 - m.m20, m.m10 - m.m01};
      case 1 -> new double[] {m.m21 - m.m12, squares[1], m.m10 + m.m01, m.m02 + m.m20};
      case 2 -> new double[] {m.m02 - m.m20, m.m10 + m.m01, squares[2], m.m21 + m.m12};
      default -> new double[] {m.m10 - m.m01, m.m02 + m.m20, m.m21 + m.m12, squares[3]};
    };
    final double sine = Math.sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    final double degrees = Math.toDegrees(2 * StrictMath.atan2(sine, q[0]));
    if ((float) degrees == 0) {
      return NONE;
    }
    final Vector3f axis = new Vector3f((float) (q[1] / sine), (float) (q[2] / sine), (float) (q[3] / sine));
    return new Rotation(m, axis, (float) degrees);
  }

  Matrix3d matrix() {
    return matrix;
  }

  /** The axis, of unit length. */
  Vector3f axis() {
    return axis;
  }

  float degrees() {
    return degrees;
  }
}
