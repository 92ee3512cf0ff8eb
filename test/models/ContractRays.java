package models;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

/** Random rays about a shape, of all kinds: towards it from near and far, from inside, along the axes, past it. */
final class ContractRays {

  private static final Vector3D[] AXES = {
    new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1),
    new Vector3D(-1, 0, 0), new Vector3D(0, -1, 0), new Vector3D(0, 0, -1),
    new Vector3D(-1, -0f, -0f), new Vector3D(-0f, 1, -0f), new Vector3D(-0f, 0, 1)
  };

  private final RandomNumbers numbers;
  private final Point3D centre;
  private final double size;

  ContractRays(final RandomNumbers numbers, final Point3D centre, final double size) {
    this.numbers = numbers;
    this.centre = centre;
    this.size = size;
  }

  Ray next() {
    final Point3D near = numbers.pointAbout(centre, 0.55 * size);
    switch (numbers.index(8)) {
      case 0: return new Ray(near, numbers.direction());
      case 1: return new Ray(near, AXES[numbers.index(AXES.length)]);
      case 2: return along(near, AXES[numbers.index(AXES.length)]);
      case 3: return new Ray(numbers.pointAbout(centre, size), numbers.direction());
      case 4: return new Ray(numbers.pointAbout(centre, 4 * size), numbers.direction());
      default: return along(near, numbers.direction());
    }
  }

  /** A ray from outside that passes a point, or nearly so. */
  private Ray along(final Point3D through, final Vector3D v) {
    final double away = size * numbers.magnitude(0, 10);
    return new Ray(new Point3D((float) (through.x - away * v.x), (float) (through.y - away * v.y),
        (float) (through.z - away * v.z)), v);
  }
}
