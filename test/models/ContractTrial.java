package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.BiConsumer;
import java.util.function.Consumer;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** Tries one law of {@link Object3DContract} with random rays, and counts them, so that no law holds vacuously. */
final class ContractTrial {

  /** Number of rays. */
  static final int RAYS = 2000;

  /** Where shapes are placed to be compared with transformed ones. */
  static final RandomPlacement[] PLACEMENTS = {
    new RandomPlacement(2.5f, new Vector3D(1, 2, 3), 40, new Vector3D(-4, 5, 6)),
    new RandomPlacement(0.01f, new Vector3D(-1, 0.5f, 0.2f), 250, new Vector3D(0.1f, -0.02f, 0.03f)),
    new RandomPlacement(300, new Vector3D(0, 1, 0), -90, new Vector3D(1000, 200, -7))
  };

  private final Object3DContract contract;
  private final Object3D shape;
  private final RandomNumbers numbers;
  private final ContractRays rays;
  private final Point3D centre;
  private final double size;

  ContractTrial(final Object3DContract contract, final String law) {
    this.contract = contract;
    shape = contract.shape(RandomPlacement.MODEL);
    numbers = new RandomNumbers(law);
    size = contract.size();
    centre = contract.centre();
    rays = new ContractRays(numbers, centre, size);
  }

  /** The shape, in its model frame. */
  Object3D shape() {
    return shape;
  }

  double size() {
    return size;
  }

  /** Tries all rays. */
  void all(final BiConsumer<Ray, Hit> law) {
    int hits = 0;
    for (int i = 0; i < RAYS; i++) {
      final Ray ray = rays.next();
      final Hit hit = shape.intersectionWith(ray);
      hits += hit.hits() ? 1 : 0;
      tryOut(law, ray, hit);
    }
    final int count = hits;
    assertTrue(count > RAYS / 20, () -> "only " + count + " hits of " + RAYS + " rays, " + numbers);
    assertTrue(count < RAYS, () -> "not one ray missed, " + numbers);
  }

  private void tryOut(final BiConsumer<Ray, Hit> law, final Ray ray, final Hit hit) {
    try {
      law.accept(ray, hit);
    } catch (AssertionError e) {
      throw new AssertionError(e.getMessage() + "; " + shape + ", " + ray + ", " + hit + ", "
          + numbers, e);
    }
  }

  /** Checks the rays that hit; returns how many. */
  int hits(final BiConsumer<Ray, Hit> law) {
    final int[] count = {0};
    all((ray, hit) -> {
      if (hit.hits()) {
        count[0]++;
        law.accept(ray, hit);
      }
    });
    return count[0];
  }

  /** Tries the rays that miss. */
  void misses(final Consumer<Ray> law) {
    all((ray, hit) -> {
      if (!hit.hits()) {
        law.accept(ray);
      }
    });
  }

  /** The same ray from a later start. */
  static Ray ahead(final Ray ray, final double t) {
    return Ray.exactly(ray.startX() + t * ray.directionX(), ray.startY() + t * ray.directionY(),
        ray.startZ() + t * ray.directionZ(), ray.directionX(), ray.directionY(), ray.directionZ());
  }

  private double distance(final Ray ray, final double t) {
    return contract.signedDistance(ray.startX() + t * ray.directionX(), ray.startY() + t * ray.directionY(),
        ray.startZ() + t * ray.directionZ());
  }

  /** A distance beyond which a ray has left the shape behind. */
  double beyond(final Ray ray) {
    final double x = ray.startX() - centre.x, y = ray.startY() - centre.y, z = ray.startZ() - centre.z;
    return Math.sqrt(x * x + y * y + z * z) + 2 * size;
  }

  /** Asserts that a ray does not change sides before a distance. Most of the points tested are close to the shape. */
  void assertOneSide(final Ray ray, final double end) {
    final double tolerance = 100 * contract.accuracy() * (size + end), middle = beyond(ray) - 2 * size;
    double most = 0, least = 0;
    for (int i = 0; i < 64; i++) {
      final double t = i < 8 ? end * numbers.between(0, 1) : middle + size * numbers.between(-1, 1);
      if (t > 0 && t < end) {
        final double distance = distance(ray, t);
        most = Math.max(most, distance);
        least = Math.min(least, distance);
      }
    }
    assertTrue(most <= tolerance || least >= -tolerance, "sides " + least + " and " + most + " before t = " + end);
  }

  /** Direction in which the distance from the surface grows most at a hit; null close to an edge, where there is none. */
  double[] slope(final Hit hit) {
    final double h = 1e-5 * size + 10 * contract.accuracy() * size;
    final double[] slope = new double[3];
    double length2 = 0;
    for (int i = 0; i < 3; i++) {
      final double at = distance(hit, i, 0), forwards = (distance(hit, i, h) - at) / h,
          backwards = (at - distance(hit, i, -h)) / h;
      if (Math.abs(forwards - backwards) > 0.02) {
        return null;
      }
      slope[i] = forwards + backwards;
      length2 += slope[i] * slope[i];
    }
    for (int i = 0; i < 3; i++) {
      slope[i] /= Math.sqrt(length2);
    }
    return slope;
  }

  private double distance(final Hit hit, final int coordinate, final double step) {
    return contract.signedDistance(hit.pointX() + (coordinate == 0 ? step : 0), hit.pointY() + (coordinate == 1 ? step : 0),
        hit.pointZ() + (coordinate == 2 ? step : 0));
  }

  /** Whether all rays close to a given one hit the same face, or miss, as it does: then rounding cannot matter. */
  boolean isSound(final Ray ray, final Hit hit) {
    for (int i = 0; i < 6; i++) {
      final double step = (i % 2 == 0 ? 1e-3 : -1e-3) * size;
      final Hit close = shape.intersectionWith(Ray.exactly(ray.startX() + (i < 2 ? step : 0),
          ray.startY() + (i == 2 || i == 3 ? step : 0), ray.startZ() + (i > 3 ? step : 0),
          ray.directionX(), ray.directionY(), ray.directionZ()));
      if (close.hits() != hit.hits() || hit.hits() && !(cosine(close, hit) > 0.97)) {
        return false;
      }
    }
    return !hit.hits() || hit.getT() > 1e-2 * size;
  }

  private static double cosine(final Hit a, final Hit b) {
    return a.normalX() * b.normalX() + a.normalY() * b.normalY() + a.normalZ() * b.normalZ();
  }

  /**
   * Asserts that two hits of a placed shape agree with each other, with their ray, and with that of the shape in its
   * model frame.
   */
  void assertAgree(final RandomPlacement at, final Ray ray, final Hit placed, final Hit transformed, final Hit hit) {
    assertEquals(hit.hits(), placed.hits(), () -> "placed at " + at);
    assertEquals(hit.hits(), transformed.hits(), () -> "transformed to " + at);
    if (!hit.hits()) {
      return;
    }
    final double tolerance = 1e-6 * (placed.getT() + at.length((float) size) + coordinates(placed))
        + contract.accuracy() * at.length((float) (size + hit.getT()));
    for (final Hit other : new Hit[] {placed, transformed}) {
      final double across = Math.abs(distanceAlongNormal(placed, other));
      assertTrue(across <= 10 * tolerance, () -> "off the surface by " + across + " in " + at + ": " + placed + ", "
          + other);
      final double t = other.getT();
      assertEquals(ray.startX() + t * ray.directionX(), other.pointX(), 10 * tolerance);
      assertEquals(ray.startY() + t * ray.directionY(), other.pointY(), 10 * tolerance);
      assertEquals(ray.startZ() + t * ray.directionZ(), other.pointZ(), 10 * tolerance);
      assertTrue(cosine(placed, other) > 1 - 1e-6, () -> "normals in " + at + ": " + placed + ", " + other);
    }
    assertEquals(placed.getT(), at.length(hit.getT()), 0.05 * at.length((float) size) + 1e-3 * placed.getT());
  }

  private static double coordinates(final Hit hit) {
    return Math.abs(hit.pointX()) + Math.abs(hit.pointY()) + Math.abs(hit.pointZ());
  }

  private static double distanceAlongNormal(final Hit a, final Hit b) {
    return (b.pointX() - a.pointX()) * a.normalX() + (b.pointY() - a.pointY()) * a.normalY()
        + (b.pointZ() - a.pointZ()) * a.normalZ();
  }
}
