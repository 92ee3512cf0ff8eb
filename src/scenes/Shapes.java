package scenes;

import models.Appearance;
import models.Box;
import models.Capsule;
import models.Cylinder;
import models.Egg;
import models.Ellipsoid;
import models.Object3D;
import models.Plane;
import models.Sphere;
import models.Torus;
import models.TruncatedCone;
import primitives.Point3D;
import primitives.Vector3D;

/** The models that are shapes of the library, each in its own frame: X to the right, Y up, Z towards the viewer. */
final class Shapes {

  private Shapes() {
  }

  /** A segment of the model from A to B, placed. */
  private record Segment(Point3D middle, Vector3D direction, float length) {

    /** The segment of a placement; its direction is null if it has no length. */
    static Segment of(final float[] a, final float[] b, final Placement placement) {
      final double x = (double) b[0] - a[0], y = (double) b[1] - a[1], z = (double) b[2] - a[2];
      final double length = Math.sqrt(x * x + y * y + z * z);
      final Point3D middle = placement.point(((double) a[0] + b[0]) / 2, ((double) a[1] + b[1]) / 2,
          ((double) a[2] + b[2]) / 2);
      return new Segment(middle, length == 0 ? null : placement.direction(x / length, y / length, z / length),
          (float) length);
    }
  }

  private static Object3D sphere(final Point3D C, final float radius, final Appearance appearance) {
    return appearance.isMaterial() ? new Sphere(C, radius, appearance.material())
        : new Sphere(C, radius, appearance.color());
  }

  /** Sphere about the origin. */
  record SphereModel(float radius) implements Model {
    @Override
    public String textureFault() {
      return null;
    }

    /** A texture rotates with the sphere, so that the centre does not determine the placement. */
    @Override
    public Object3D placed(final Placement placement, final Appearance appearance) {
      return appearance.texture() == null ? Model.super.placed(placement, appearance)
          : placement.applied(new Sphere(new Point3D(), radius, appearance.texture()));
    }

    @Override
    public Object3D at(final Placement placement, final Appearance appearance) {
      return sphere(placement.point(0, 0, 0), radius, appearance);
    }
  }

  /** Box about the origin: width along X, height along Y, depth along Z. */
  record BoxModel(float width, float height, float depth) implements Model {
    @Override
    public Object3D at(final Placement placement, final Appearance appearance) {
      final Point3D C = placement.point(0, 0, 0);
      final Vector3D i = placement.direction(1, 0, 0), j = placement.direction(0, 1, 0);
      return appearance.isMaterial() ? new Box(C, i, j, width, height, depth, appearance.material())
          : new Box(C, i, j, width, height, depth, appearance.color());
    }
  }

  /** Plane through a point, perpendicular to a normal. */
  record PlaneModel(float[] point, float[] normal) implements Model {
    @Override
    public Object3D at(final Placement placement, final Appearance appearance) {
      final Point3D P = placement.point(point[0], point[1], point[2]);
      final Vector3D n = placement.direction(normal[0], normal[1], normal[2]);
      return appearance.isMaterial() ? new Plane(P, n, appearance.material()) : new Plane(P, n, appearance.color());
    }
  }

  /** Closed cylinder about the origin, its axis along Y. */
  record CylinderModel(float radius, float length) implements Model {
    @Override
    public Object3D at(final Placement placement, final Appearance appearance) {
      final Point3D P = placement.point(0, 0, 0);
      final Vector3D u = placement.direction(0, 1, 0);
      return appearance.isMaterial() ? new Cylinder(P, u, radius, length, appearance.material())
          : new Cylinder(P, u, radius, length, appearance.color());
    }
  }

  /** All points within a radius of the segment from A to B: a sphere if they are one point. */
  record CapsuleModel(float[] a, float[] b, float radius) implements Model {
    @Override
    public Object3D at(final Placement placement, final Appearance appearance) {
      final Segment axis = Segment.of(a, b, placement);
      if (axis.length == 0) {
        return sphere(axis.middle, radius, appearance);
      }
      return appearance.isMaterial() ? new Capsule(axis.middle, axis.direction, radius, axis.length, appearance.material())
          : new Capsule(axis.middle, axis.direction, radius, axis.length, appearance.color());
    }
  }

  /** Truncated cone from A to B, which differ, closed by a disc at each end whose radius is not 0. */
  record TruncatedConeModel(float[] a, float[] b, float radiusA, float radiusB) implements Model {
    @Override
    public Object3D at(final Placement placement, final Appearance appearance) {
      final Segment axis = Segment.of(a, b, placement);
      return appearance.isMaterial()
          ? new TruncatedCone(axis.middle, axis.direction, radiusA, radiusB, axis.length, appearance.material())
          : new TruncatedCone(axis.middle, axis.direction, radiusA, radiusB, axis.length, appearance.color());
    }
  }

  /** Torus about the origin, its axis along Y. */
  record TorusModel(float rotationalRadius, float tubeRadius) implements Model {
    @Override
    public Object3D at(final Placement placement, final Appearance appearance) {
      final Point3D C = placement.point(0, 0, 0);
      final Vector3D axis = placement.direction(0, 1, 0);
      return appearance.isMaterial() ? new Torus(C, axis, rotationalRadius, tubeRadius, appearance.material())
          : new Torus(C, axis, rotationalRadius, tubeRadius, appearance.color());
    }
  }

  /** Ellipsoid about the origin: half-axes a on X, b on Y, c on Z. */
  record EllipsoidModel(float a, float b, float c) implements Model {
    @Override
    public Object3D at(final Placement placement, final Appearance appearance) {
      final Point3D C = placement.point(0, 0, 0);
      final Vector3D i = placement.direction(1, 0, 0), j = placement.direction(0, 1, 0);
      return appearance.isMaterial() ? new Ellipsoid(C, i, j, a, b, c, appearance.material())
          : new Ellipsoid(C, i, j, a, b, c, appearance.color());
    }
  }

  /** Egg about the origin, its axis along Y, the pointed pole above. */
  record EggModel(float a, float b, float w) implements Model {
    @Override
    public Object3D at(final Placement placement, final Appearance appearance) {
      final Point3D C = placement.point(0, 0, 0);
      final Vector3D axis = placement.direction(0, 1, 0);
      return appearance.isMaterial() ? new Egg(C, axis, a, b, w, appearance.material())
          : new Egg(C, axis, a, b, w, appearance.color());
    }
  }
}
