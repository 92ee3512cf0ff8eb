package models;

import javax.vecmath.AxisAngle4d;
import javax.vecmath.Matrix3d;
import javax.vecmath.Vector3d;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

/**
 * Where a test places a shape: scaled uniformly, rotated and translated from its model frame. A shape is placed by
 * sending all points, directions and lengths of its constructor through here.
 */
public final class RandomPlacement {

  /** The identity. */
  public static final RandomPlacement MODEL = scaled(1);

  private final float scale;
  private final Vector3D axis;
  private final float theta;
  private final Vector3D shift;
  private final Matrix3d rotation = new Matrix3d();

  /**
   * A placement.
   *
   * @param scale factor of all lengths, &gt; 0
   * @param axis axis of the rotation
   * @param theta its angle in degrees
   * @param shift translation, after the rotation
   */
  public RandomPlacement(final float scale, final Vector3D axis, final float theta, final Vector3D shift) {
    this.scale = scale;
    this.axis = new Vector3D(axis);
    this.theta = theta;
    this.shift = new Vector3D(shift);
    final Vector3d unit = new Vector3d(axis);
    unit.normalize();
    rotation.set(new AxisAngle4d(unit, Math.toRadians(theta)));
  }

  /** All lengths times a factor; exact if that is a power of two. */
  static RandomPlacement scaled(final float factor) {
    return new RandomPlacement(factor, new Vector3D(0, 0, 1), 0, new Vector3D());
  }

  /**
   * A point of the model.
   *
   * @param x first coordinate in the model's frame
   * @param y second coordinate
   * @param z third coordinate
   * @return the point in the scene
   */
  public Point3D point(final double x, final double y, final double z) {
    return new Point3D((float) (scale * turned(0, x, y, z) + shift.x), (float) (scale * turned(1, x, y, z) + shift.y),
        (float) (scale * turned(2, x, y, z) + shift.z));
  }

  /**
   * A direction of the model: rotated, neither scaled nor translated.
   *
   * @param x first component in the model's frame
   * @param y second component
   * @param z third component
   * @return the vector in the scene
   */
  public Vector3D direction(final double x, final double y, final double z) {
    return new Vector3D((float) turned(0, x, y, z), (float) turned(1, x, y, z), (float) turned(2, x, y, z));
  }

  /**
   * A length of the model.
   *
   * @param l the length in the model's frame
   * @return the length in the scene
   */
  public float length(final float l) {
    return scale * l;
  }

  private double turned(final int row, final double x, final double y, final double z) {
    return rotation.getElement(row, 0) * x + rotation.getElement(row, 1) * y + rotation.getElement(row, 2) * z;
  }

  /** A ray of the model's frame, at the same place relative to the shape. */
  Ray ray(final Ray ray) {
    return new Ray(point(ray.startX(), ray.startY(), ray.startZ()),
        direction(ray.directionX(), ray.directionY(), ray.directionZ()));
  }

  /** A shape of the model's frame, placed by the class under test. */
  AffineTransformation transformed(final Object3D shape) {
    return new AffineTransformation(new Vector3D(scale, scale, scale), axis, theta, shift, shape);
  }

  @Override
  public String toString() {
    return "scale " + scale + ", axis " + axis + ", theta " + theta + ", shift " + shift;
  }
}
