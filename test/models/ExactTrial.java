package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Function;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

/** Shapes against the oracle in decimals: hit or miss, and how far away, from starts inside to 10⁷ sizes away. */
final class ExactTrial {

  /**
   * A line that misses, or enters, the solid by less than this fraction of its size, per size of distance, is left out.
   */
  private static final double DOUBT = 1e-15;

  private final RandomNumbers numbers;
  private int hits;
  private int misses;
  private int doubts;

  ExactTrial(final String test) {
    numbers = new RandomNumbers(test);
  }

  RandomNumbers numbers() {
    return numbers;
  }

  /** Tries rays towards a shape within a sphere about a centre, most of which come close to its surface. */
  void ask(final Object3D shape, final Point3D centre, final double size, final int rays,
      final Function<ExactSpan.Line, ExactSpan> oracle) {
    for (int i = 0; i < rays; i++) {
      final double away = size * numbers.magnitude(-3, Math.log(1e7) / Math.log(2));
      final Vector3D v = numbers.direction(), aside = new Vector3D();
      aside.cross(v, numbers.direction());
      aside.normalize();
      final double off = size * numbers.between(0, 1);
      final Point3D R = new Point3D((float) (centre.x - away * v.x + off * aside.x),
          (float) (centre.y - away * v.y + off * aside.y), (float) (centre.z - away * v.z + off * aside.z));
      ask(shape, new Ray(R, v), away / size, oracle);
    }
  }

  private void ask(final Object3D shape, final Ray ray, final double sizesAway,
      final Function<ExactSpan.Line, ExactSpan> oracle) {
    final ExactSpan span = oracle.apply(ExactSpan.Line.of(ray));
    final double doubt = DOUBT * (1000 + 100 * sizesAway);
    if (!(Math.abs(span.gap()) > doubt)) {
      doubts++;
      return;
    }
    final double t = span.first();
    final Hit hit = shape.intersectionWith(ray);
    final String what = shape + ", " + ray + ", exactly " + t + ": " + hit + ", " + numbers;
    assertEquals(t < Double.POSITIVE_INFINITY, hit.hits(), what);
    if (hit.hits()) {
      hits++;
      final double rounding = doubt / Math.sqrt(Math.min(1, Math.abs(span.gap())));
      assertEquals(t, hit.getT(), 1.2e-7 * t + rounding * t / Math.max(sizesAway, 1e-3), what);
    } else {
      misses++;
    }
  }

  /** Asserts that enough rays were tried. */
  void assertCounts(final int leastHits, final int leastMisses, final int mostDoubts) {
    assertTrue(hits >= leastHits && misses >= leastMisses && doubts <= mostDoubts,
        () -> hits + " hits, " + misses + " misses, " + doubts + " in doubt, " + numbers);
  }
}
