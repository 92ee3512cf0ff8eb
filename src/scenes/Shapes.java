package scenes;

import java.awt.Color;

import models.Box;
import models.Capsule;
import models.Cylinder;
import models.Ellipsoid;
import models.Object3D;
import models.Plane;
import models.Sphere;
import models.Torus;

/** The models that are shapes of the library, each in its own frame: X to the right, Y up, Z towards the viewer. */
final class Shapes {

  private Shapes() {
  }

  /** Sphere about the origin. */
  record SphereModel(float radius) implements Model {
    @Override
    public Object3D at(final Placement placement, final Color color) {
      return new Sphere(placement.point(0, 0, 0), radius, color);
    }
  }

  /** Box about the origin: width along X, height along Y, depth along Z. */
  record BoxModel(float width, float height, float depth) implements Model {
    @Override
    public Object3D at(final Placement placement, final Color color) {
      return new Box(placement.point(0, 0, 0), placement.direction(1, 0, 0), placement.direction(0, 1, 0),
          width, height, depth, color);
    }
  }

  /** Plane through a point, perpendicular to a normal. */
  record PlaneModel(float[] point, float[] normal) implements Model {
    @Override
    public Object3D at(final Placement placement, final Color color) {
      return new Plane(placement.point(point[0], point[1], point[2]),
          placement.direction(normal[0], normal[1], normal[2]), color);
    }
  }

  /** Closed cylinder about the origin, its axis along Y. */
  record CylinderModel(float radius, float length) implements Model {
    @Override
    public Object3D at(final Placement placement, final Color color) {
      return new Cylinder(placement.point(0, 0, 0), placement.direction(0, 1, 0), radius, length, color);
    }
  }

  /** All points within a radius of the segment from A to B: a sphere if they are one point. */
  record CapsuleModel(float[] a, float[] b, float radius) implements Model {
    @Override
    public Object3D at(final Placement placement, final Color color) {
      final double x = (double) b[0] - a[0], y = (double) b[1] - a[1], z = (double) b[2] - a[2];
      final double length = Math.sqrt(x * x + y * y + z * z);
      final var middle = placement.point(((double) a[0] + b[0]) / 2, ((double) a[1] + b[1]) / 2, ((double) a[2] + b[2]) / 2);
      if (length == 0) {
        return new Sphere(middle, radius, color);
      }
      final var axis = placement.direction(x / length, y / length, z / length);
      return new Capsule(middle, axis, radius, (float) length, color);
    }
  }

  /** Torus about the origin, its axis along Y. */
  record TorusModel(float rotationalRadius, float tubeRadius) implements Model {
    @Override
    public Object3D at(final Placement placement, final Color color) {
      return new Torus(placement.point(0, 0, 0), placement.direction(0, 1, 0), rotationalRadius, tubeRadius, color);
    }
  }

  /** Ellipsoid about the origin: half-axes a on X, b on Y, c on Z. */
  record EllipsoidModel(float a, float b, float c) implements Model {
    @Override
    public Object3D at(final Placement placement, final Color color) {
      return new Ellipsoid(placement.point(0, 0, 0), placement.direction(1, 0, 0), placement.direction(0, 1, 0),
          a, b, c, color);
    }
  }
}
