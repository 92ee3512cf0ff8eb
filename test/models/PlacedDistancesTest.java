package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;
import java.util.function.Function;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;

/** Signed distances and their bounds move with the shape: a shape that is scaled, turned and moved has them scaled. */
class PlacedDistancesTest {

  private static final List<Function<RandomPlacement, ProceduralObject3D>> SHAPES = List.of(
      at -> new Ellipsoid(at.point(1, -2, 0.5), at.direction(1, 0, 2), at.direction(0, 1, 0), at.length(2), at.length(0.7f),
          at.length(1), Color.RED),
      at -> new Torus(at.point(-1, 0.5, 2), at.direction(2, -1, 2), at.length(2), at.length(0.75f), Color.RED));

  @Test
  void distancesOfAPlacedShapeAreThoseOfTheShapeTimesItsScale() {
    final RandomNumbers numbers = new RandomNumbers("placed distances");
    for (int i = 0; i < 500; i++) {
      final float scale = numbers.magnitude(-10, 10);
      final Vector3D axis = numbers.direction(), shift = numbers.direction();
      shift.scale(10 * scale);
      final RandomPlacement at = new RandomPlacement(scale, axis, (float) numbers.between(0, 360), shift);
      for (final Function<RandomPlacement, ProceduralObject3D> maker : SHAPES) {
        final ProceduralObject3D model = maker.apply(RandomPlacement.MODEL), placed = maker.apply(at);
        final Point3D P = numbers.pointAbout(new Point3D(), 4), there = at.point(P.x, P.y, P.z);
        final double tolerance = 1e-4 * scale;
        assertEquals(scale * model.signedDistance(P.x, P.y, P.z), placed.signedDistance(there.x, there.y, there.z),
            tolerance, () -> placed + ", " + there + ", " + numbers);
        assertEquals(scale * model.SDF(P), placed.SDF(there), tolerance, () -> placed + ", " + there + ", " + numbers);
        assertEquals(scale * model.distanceUpperBound(P), placed.distanceUpperBound(there), tolerance,
            () -> placed + ", " + there + ", " + numbers);
      }
    }
  }

  /** A hit is at distance 0; a step along its normal is outside, one against it inside, and no more than its length away. */
  @Test
  void distancesHaveTheSideOfThePoint() {
    final RandomNumbers numbers = new RandomNumbers("sides of distances");
    for (int i = 0; i < 500; i++) {
      final ProceduralObject3D shape = SHAPES.get(i % 2).apply(RandomPlacement.MODEL);
      final Point3D C = new Point3D();
      C.interpolate(shape.getBoundingBox().getMin(), shape.getBoundingBox().getMax(), 0.5f);
      final Vector3D v = numbers.direction();
      final var hit = shape.intersectionWith(new tracer.Ray(new Point3D(C.x + 9 * v.x, C.y + 9 * v.y, C.z + 9 * v.z),
          numbers.pointAbout(C, 0.5)));
      if (hit.hits()) {
        final double x = hit.pointX(), y = hit.pointY(), z = hit.pointZ(), k = 1e-3;
        assertEquals(0, shape.signedDistance(x, y, z), 1e-12);
        final double out = shape.signedDistance(x + k * hit.normalX(), y + k * hit.normalY(), z + k * hit.normalZ());
        final double in = shape.signedDistance(x - k * hit.normalX(), y - k * hit.normalY(), z - k * hit.normalZ());
        assertTrue(out > 0.9 * k && out < k * (1 + 1e-9) && in < -0.9 * k && in > -k * (1 + 1e-9),
            () -> shape + ", " + hit + ": " + in + ", " + out + ", " + numbers);
      }
    }
  }
}
