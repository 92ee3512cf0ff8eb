package models;

import static models.HitAssertions.assertSameHit;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

import org.junit.jupiter.api.Test;

import primitives.BoundingBox;
import primitives.Point3D;
import tracer.Hit;
import tracer.Ray;

/**
 * The laws that every {@link Object3D} must obey, as tests. The test of a shape implements this interface and so inherits
 * them; it has to implement two methods:
 *
 * <pre>{@code
 * class BallTest implements Object3DContract {
 *   public Object3D shape(RandomPlacement at) {
 *     return new Sphere(at.point(1, 2, 3), at.length(4), Color.RED);
 *   }
 *
 *   public double signedDistance(double x, double y, double z) {
 *     return Math.hypot(Math.hypot(x - 1, y - 2), z - 3) - 4;
 *   }
 * }
 * }</pre>
 *
 * <p>It sends all points, directions and lengths through the placement, so that the same shape can be constructed in
 * place, a million times as large, or rotated and translated. A shape without volume, such as a triangle, returns false
 * from {@link #isClosed}; one without a bounding box should override {@link #size} and {@link #centre}. Distances and
 * normals have to be as accurate as {@link #accuracy} says, relative to the lengths involved. The tests of this package
 * implement it, {@code StudentsObjectTest} for a shape such as a student would write.
 */
public interface Object3DContract {

  /**
   * The shape to be tested.
   *
   * @param at its placement
   * @return a new shape
   */
  Object3D shape(RandomPlacement at);

  /**
   * Signed distance of a point from the surface, computed straightforwardly, or any function with its sign whose slope at
   * the surface is about 1.
   *
   * @param x first coordinate of the point, in the model's frame (where {@link RandomPlacement#MODEL} leaves the shape)
   * @param y second coordinate
   * @param z third coordinate
   * @return negative inside, positive outside; of an open surface, negative on the side behind its normal
   */
  double signedDistance(double x, double y, double z);

  /**
   * Whether the surface separates inside from outside, as that of a solid or a plane does.
   *
   * @return true unless overridden
   */
  default boolean isClosed() {
    return true;
  }

  /**
   * Accuracy of hits, relative to the lengths involved.
   *
   * @return 1e-5 unless overridden
   */
  default double accuracy() {
    return 1e-5;
  }

  /**
   * Extent of the shape.
   *
   * @return that of its box, or 4 if it has none
   */
  default double size() {
    final BoundingBox box = shape(RandomPlacement.MODEL).getBoundingBox();
    return !box.isFinite() ? 4
        : Math.max(box.maxX() - box.minX(), Math.max(box.maxY() - box.minY(), box.maxZ() - box.minZ()));
  }

  /**
   * Middle of the shape.
   *
   * @return that of its box, or the origin if it has none
   */
  default Point3D centre() {
    final BoundingBox box = shape(RandomPlacement.MODEL).getBoundingBox();
    final Point3D centre = new Point3D();
    if (box.isFinite()) {
      centre.interpolate(box.getMin(), box.getMax(), 0.5f);
    }
    return centre;
  }

  /** Points are on the ray at the distance t, and on the surface; the object has a colour. */
  @Test
  default void hitsLieOnTheRayAndOnTheSurface() {
    final ContractTrial trial = new ContractTrial(this, "on ray and surface");
    trial.hits((ray, hit) -> {
      final double t = hit.getT(), scale = trial.size() + t + largest(ray.startX(), ray.startY(), ray.startZ());
      final double tolerance = accuracy() * scale + 0x1p-23 * t;
      assertTrue(t > 0 && t < Float.POSITIVE_INFINITY);
      assertEquals(ray.startX() + t * ray.directionX(), hit.pointX(), tolerance);
      assertEquals(ray.startY() + t * ray.directionY(), hit.pointY(), tolerance);
      assertEquals(ray.startZ() + t * ray.directionZ(), hit.pointZ(), tolerance);
      assertEquals(0, signedDistance(hit.pointX(), hit.pointY(), hit.pointZ()), accuracy() * scale);
      assertEquals(new Point3D((float) hit.pointX(), (float) hit.pointY(), (float) hit.pointZ()), hit.getPoint());
      assertNotNull(hit.getObject().getColor());
    });
  }

  /** Normals have unit length and the direction in which the signed distance grows. */
  @Test
  default void normalsAreUnitVectorsThatPointOut() {
    final ContractTrial trial = new ContractTrial(this, "normals");
    final int[] smooth = {0};
    final int hits = trial.hits((ray, hit) -> {
      assertEquals(1, hit.getNormal().length(), 1e-6);
      final double[] n = {hit.normalX(), hit.normalY(), hit.normalZ()}, slope = trial.slope(hit);
      if (slope != null) {
        smooth[0]++;
        for (int i = 0; i < 3; i++) {
          assertEquals(slope[i], n[i], 1e-3);
        }
      }
    });
    assertTrue(smooth[0] > hits / 2, () -> "only " + smooth[0] + " of " + hits + " hits where the slope could be measured");
  }

  /** Nothing is crossed before the hit: the side does not change, and a ray that starts later hits at the same place. */
  @Test
  default void theHitIsTheFirst() {
    final ContractTrial trial = new ContractTrial(this, "first hit");
    trial.hits((ray, hit) -> {
      final double t = hit.getT(), tolerance = 100 * accuracy() * (trial.size() + t) + 0x1p-22 * t;
      if (isClosed()) {
        trial.assertOneSide(ray, t - tolerance);
      }
      for (int i = 1; i < 8; i++) {
        final double ahead = t * i / 8;
        if (t - ahead > tolerance) {
          final Hit later = trial.shape().intersectionWith(ContractTrial.ahead(ray, ahead));
          assertEquals(t - ahead, later.getT(), tolerance);
        }
      }
    });
  }

  /** A ray that hits nothing does not change sides. */
  @Test
  default void missesCrossNothing() {
    final ContractTrial trial = new ContractTrial(this, "misses");
    trial.misses(ray -> {
      if (isClosed()) {
        trial.assertOneSide(ray, trial.beyond(ray));
      }
    });
  }

  /** The points of hits are in the box, and a ray that misses the box misses the shape. */
  @Test
  default void theBoxContainsEveryHit() {
    final BoundingBox box = shape(RandomPlacement.MODEL).getBoundingBox();
    new ContractTrial(this, "box").all((ray, hit) -> {
      final boolean crosses = box.isCrossedBy(ray.startX(), ray.startY(), ray.startZ(),
          ray.directionX(), ray.directionY(), ray.directionZ());
      assertTrue(crosses || !hit.hits(), "a hit off the box");
      assertTrue(!hit.hits() || box.contains(hit.getPoint()), "a point off the box");
    });
  }

  /** Scaling all lengths by a power of two scales t by the same, bit for bit: the shape has no absolute tolerance. */
  @Test
  default void scalingByAPowerOfTwoScalesTheHitExactly() {
    for (final float factor : new float[] {0x1p20f, 0x1p-20f}) {
      final Object3D scaled = shape(RandomPlacement.scaled(factor));
      new ContractTrial(this, "scaling").all((ray, hit) -> {
        final Hit scaledHit = scaled.intersectionWith(Ray.exactly(factor * ray.startX(), factor * ray.startY(),
            factor * ray.startZ(), ray.directionX(), ray.directionY(), ray.directionZ()));
        assertEquals(hit.getT() * factor, scaledHit.getT(), "t");
        assertEquals(hit.getNormal(), scaledHit.getNormal(), "normal");
      });
    }
  }

  /** A shape in an {@link AffineTransformation} agrees with one constructed in the transformed place. */
  @Test
  default void theTransformedShapeAgreesWithOnePlacedSo() {
    for (final RandomPlacement at : ContractTrial.PLACEMENTS) {
      final ContractTrial trial = new ContractTrial(this, "transformation");
      final Object3D placed = shape(at), transformed = at.transformed(shape(RandomPlacement.MODEL));
      final int[] compared = {0};
      trial.all((ray, hit) -> {
        if (trial.isSound(ray, hit)) {
          compared[0]++;
          final Ray there = at.ray(ray);
          trial.assertAgree(at, there, placed.intersectionWith(there), transformed.intersectionWith(there), hit);
        }
      });
      assertTrue(compared[0] > ContractTrial.RAYS / 3, () -> "only " + compared[0] + " rays far enough from an edge");
    }
  }

  /** In a group, also with others farther away, the shape gives the same hits as alone. */
  @Test
  default void aGroupAnswersAsTheShapeDoes() {
    final ContractTrial trial = new ContractTrial(this, "group");
    final Group3D group = new Group3D(), outer = new Group3D();
    for (int i = 0; i < 9; i++) {
      final Point3D far = centre();
      far.x += (float) (1e9 * size() * (i - 4.5));
      group.addObject(new Sphere(far, (float) size(), Color.BLACK));
    }
    group.addObject(trial.shape());
    outer.addObject(group);
    trial.all((ray, hit) -> {
      final Hit found = outer.intersectionWith(ray);
      if (hit.hits() || found.hits() && found.getT() < 1e6 * trial.size()) {
        assertSameHit(hit, found, "in a group");
      }
    });
  }

  /** The same ray gives the same hit, from all threads at once too. */
  @Test
  default void severalThreadsGetTheSameAnswers() throws Exception {
    final ContractTrial trial = new ContractTrial(this, "threads");
    final List<Ray> rays = new ArrayList<>();
    final List<Hit> expected = new ArrayList<>();
    trial.all((ray, hit) -> {
      rays.add(ray);
      expected.add(hit);
    });
    final ExecutorService threads = Executors.newFixedThreadPool(4);
    try {
      final List<Future<?>> ends = new ArrayList<>();
      for (int k = 0; k < 4; k++) {
        ends.add(threads.submit(() -> {
          for (int i = 0; i < rays.size(); i++) {
            assertSameHit(expected.get(i), trial.shape().intersectionWith(rays.get(i)), rays.get(i).toString());
          }
        }));
      }
      for (final Future<?> end : ends) {
        end.get();
      }
    } finally {
      threads.shutdown();
    }
  }

  /** The absence of a ray hits nothing. */
  @Test
  default void theAbsentRayMisses() {
    assertSame(Hit.NOHIT, shape(RandomPlacement.MODEL).intersectionWith(Ray.NORAY));
  }

  /** Rays of NaN or infinite numbers hit nothing, and the search for a hit ends. */
  @Test
  default void raysThatAreNotFiniteMiss() {
    final Object3D shape = shape(RandomPlacement.MODEL);
    for (final double wrong : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
      for (int i = 0; i < 6; i++) {
        final double[] r = {0.1, 0.2, 0.3, 0.48, 0.6, 0.64};
        r[i] = wrong;
        final Ray ray = Ray.exactly(r[0], r[1], r[2], r[3], r[4], r[5]);
        assertSame(Hit.NOHIT, shape.intersectionWith(ray), () -> shape + ", " + Arrays.toString(r));
      }
    }
  }

  /** A null ray is a wrong argument. */
  @Test
  default void nullIsNoRay() {
    final Object3D shape = shape(RandomPlacement.MODEL);
    final String message = assertThrows(IllegalArgumentException.class, () -> shape.intersectionWith(null)).getMessage();
    assertTrue(message.contains("ray"), message);
  }

  /** Changing a returned point or normal does not change the hit. */
  @Test
  default void callersCannotChangeAHit() {
    new ContractTrial(this, "copies").hits((ray, hit) -> {
      final String before = hit.toString();
      hit.getPoint().scale(7);
      hit.getNormal().negate();
      assertEquals(before, hit.toString());
    });
  }

  private static double largest(final double a, final double b, final double c) {
    return Math.max(Math.abs(a), Math.max(Math.abs(b), Math.abs(c)));
  }
}
