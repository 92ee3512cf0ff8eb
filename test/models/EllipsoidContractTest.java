package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** The laws for an ellipsoid; its accuracy in difficult cases is tested separately. */
class EllipsoidContractTest implements Object3DContract {

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Ellipsoid(at.point(1, 1, -2), at.direction(2, 2, 1), at.direction(-2, 1, 0), at.length(3), at.length(1),
        at.length(1.5f), Color.RED);
  }

  /** i = (2, 2, 1)/3; k = i × (−2, 1, 0) normalised = (−1, −2, 6)/√41; j = k × i. */
  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double px = x - 1, py = y - 1, pz = z + 2, s = Math.sqrt(41), kx = -1 / s, ky = -2 / s, kz = 6 / s;
    final double jx = (ky - 2 * kz) / 3, jy = (2 * kz - kx) / 3, jz = (2 * kx - 2 * ky) / 3;
    final double a = (2 * px + 2 * py + pz) / 9, b = jx * px + jy * py + jz * pz, c = (kx * px + ky * py + kz * pz) / 1.5;
    final double k = Math.sqrt(a * a + b * b + c * c), g = Math.sqrt(a * a / 9 + b * b + c * c / 2.25);
    return k < 0.01 ? -0.9 : k * (k - 1) / g;
  }

  @Override
  public double accuracy() {
    return 1e-8;
  }

  /** A unit sphere stretched by (3, 0.5, 2), turned by 90° about z so that i becomes y, and moved. */
  @Test
  void agreesWithATransformedSphere() {
    final Object3D sphere = new AffineTransformation(new Vector3f(3, 0.5f, 2), new Vector3f(0, 0, 1), 90,
        new Vector3f(1, 2, 3), new Sphere(new Point3D(), 1, Color.RED));
    final Ellipsoid ellipsoid = new Ellipsoid(new Point3D(1, 2, 3), new Vector3D(0, 1, 0), new Vector3D(-1, 5, 0), 3, 0.5f,
        2, Color.RED);
    final RandomNumbers numbers = new RandomNumbers("ellipsoid as a sphere");
    final ContractRays rays = new ContractRays(numbers, new Point3D(1, 2, 3), 6);
    int hits = 0;
    for (int i = 0; i < RandomNumbers.times(5000); i++) {
      final Ray ray = rays.next();
      final Hit expected = sphere.intersectionWith(ray), hit = ellipsoid.intersectionWith(ray);
      final String what = ray + ": " + expected + ", " + hit + ", " + numbers;
      assertEquals(expected.hits(), hit.hits(), what);
      if (hit.hits()) {
        hits++;
        assertEquals(expected.getT(), hit.getT(), 1e-6 * (6 + hit.getT()), what);
        HitAssertions.assertClose(expected.getNormal(), hit.getNormal(), 1e-3, what);
      }
    }
    assertTrue(hits > RandomNumbers.times(500), hits + " hits");
  }
}
