package scenes;

import java.util.Arrays;

import javax.vecmath.Matrix3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;

import models.AffineTransformation;
import models.Object3D;
import primitives.Point3D;
import primitives.Vector3D;

/**
 * The placement of an object: its model is scaled, then rotated, then translated.
 *
 * <p>Both rotations of the scene language, by aiming and about an axis, are combined here, so that one transformation is
 * enough.
 */
final class Placement {

  private static final float[] ONE = {1, 1, 1};
  private static final float[] ZERO = {0, 0, 0};

  /** The model as it is. */
  static final Placement NONE = new Placement(ONE, Rotation.NONE, ZERO, null);

  private final float[] scale;
  private final Rotation turn;
  private final float[] shift;
  private final ExactPlacement exact;

  Placement(final float[] scale, final Rotation turn, final float[] shift, final ExactPlacement exact) {
    this.scale = scale;
    this.turn = turn;
    this.shift = shift;
    this.exact = exact;
  }

  /** The placement in double precision. */
  ExactPlacement exact() {
    return exact;
  }

  /** The placement that {@link #applied} makes, as numbers. */
  ExactPlacement rounded() {
    final float[] axis = new float[3];
    turn.axis().get(axis);
    return new ExactPlacement(new Vector3d(scale[0], scale[1], scale[2]),
        new Matrix3d(Rotation.about(axis, turn.degrees()).matrix()), new Vector3d(shift[0], shift[1], shift[2]));
  }

  /** The factors of an object that is not scaled. */
  static float[] unscaled() {
    return ONE.clone();
  }

  /** The translation of an object that is not moved. */
  static float[] unmoved() {
    return ZERO.clone();
  }

  /** Whether the placement is rigid, so that a shape can be constructed in place. */
  boolean isRigid() {
    return Arrays.equals(scale, ONE);
  }

  /** Where a rigid placement takes a point of the model. */
  Point3D point(final double x, final double y, final double z) {
    final Matrix3d m = turn.matrix();
    return new Point3D((float) (m.m00 * x + m.m01 * y + m.m02 * z + shift[0]),
        (float) (m.m10 * x + m.m11 * y + m.m12 * z + shift[1]), (float) (m.m20 * x + m.m21 * y + m.m22 * z + shift[2]));
  }

  /** Where a rigid placement takes a direction of the model. */
  Vector3D direction(final double x, final double y, final double z) {
    final Matrix3d m = turn.matrix();
    return new Vector3D((float) (m.m00 * x + m.m01 * y + m.m02 * z), (float) (m.m10 * x + m.m11 * y + m.m12 * z),
        (float) (m.m20 * x + m.m21 * y + m.m22 * z));
  }

  /** An object placed by a transformation; the object itself if the placement is the identity. */
  Object3D applied(final Object3D object) {
    final Vector3f s = new Vector3f(scale);
    final Vector3f d = new Vector3f(shift);
    if (turn != Rotation.NONE) {
      return new AffineTransformation(s, turn.axis(), turn.degrees(), d, object);
    }
    return isRigid() && Arrays.equals(shift, ZERO) ? object : new AffineTransformation(s, d, object);
  }
}
