package models;

import static models.ExactVector.DIGITS;

import java.math.BigDecimal;

import primitives.Point3D;
import primitives.Vector3D;

/**
 * The part of a line within an egg, in decimals of 50 digits: the roots of the cubic by bisection, separated by its minimum.
 */
final class ExactEgg {

  private static final BigDecimal TWO = new BigDecimal(2);
  private static final BigDecimal THREE = new BigDecimal(3);
  private static final BigDecimal HALF = new BigDecimal(0.5);
  private static final int HALVINGS = 110;
  private static final ExactSpan NONE = new ExactSpan(BigDecimal.ONE, BigDecimal.ZERO, Double.NEGATIVE_INFINITY);

  private final ExactVector centre;
  private final ExactVector u;
  private final BigDecimal a;
  private final BigDecimal b;
  private final BigDecimal w;

  ExactEgg(final Point3D C, final Vector3D axis, final float a, final float b, final float w) {
    centre = ExactVector.of(C);
    u = ExactVector.of(axis).normalised();
    this.a = new BigDecimal(a);
    this.b = new BigDecimal(b);
    this.w = new BigDecimal(w);
  }

  /** (x² + z²) (b² + 2 w y + w²) + a² y² − a² b². */
  BigDecimal value(final ExactVector P) {
    final ExactVector o = P.minus(centre);
    final BigDecimal y = o.dot(u);
    return o.dot(o).subtract(y.multiply(y)).multiply(square(b).add(square(w)).add(TWO.multiply(w).multiply(y)))
        .add(square(a).multiply(square(y).subtract(square(b))), DIGITS);
  }

  /** The gap is the depth of the minimum in parts of a² b². */
  ExactSpan span(final ExactSpan.Line line) {
    final double size = a.max(b).doubleValue();
    final ExactSpan around = ExactSpan.cylinder(line, centre, u, a).and(ExactSpan.slab(line, centre, u, b), size);
    if (around.isEmpty()) {
      return around;
    }
    final BigDecimal near = centre.minus(line.start()).dot(line.direction());
    final BigDecimal[] f = cubic(line.start().plus(line.direction().times(near)), line.direction());
    final BigDecimal discriminant = square(f[2]).subtract(THREE.multiply(f[3]).multiply(f[1]), DIGITS);
    if (discriminant.signum() < 0) {
      return NONE;
    }
    final BigDecimal root = ExactVector.root(discriminant);
    final BigDecimal minimum = f[2].signum() >= 0 ? f[1].negate().divide(f[2].add(root), DIGITS)
        : root.subtract(f[2]).divide(THREE.multiply(f[3]), DIGITS);
    final BigDecimal first = around.enter().subtract(near), last = around.leave().subtract(near);
    final BigDecimal lowest = minimum.max(first).min(last), depth = at(f, lowest);
    final double gap = -depth.divide(square(a.multiply(b)), DIGITS).doubleValue();
    return depth.signum() >= 0 ? new ExactSpan(BigDecimal.ONE, BigDecimal.ZERO, gap)
        : new ExactSpan(bisect(f, first, lowest).add(near), bisect(f, last, lowest).add(near), gap);
  }

  private BigDecimal[] cubic(final ExactVector P, final ExactVector d) {
    final ExactVector o = P.minus(centre);
    final BigDecimal y = o.dot(u), dy = d.dot(u);
    final BigDecimal q0 = square(b).add(square(w)).add(TWO.multiply(w).multiply(y)), q1 = TWO.multiply(w).multiply(dy);
    final BigDecimal r2 = d.dot(d).subtract(square(dy)), r1 = o.dot(d).subtract(y.multiply(dy)),
        r0 = o.dot(o).subtract(square(y));
    return new BigDecimal[] {
      r0.multiply(q0).add(square(a).multiply(square(y).subtract(square(b))), DIGITS),
      TWO.multiply(r1).multiply(q0).add(r0.multiply(q1)).add(TWO.multiply(square(a)).multiply(y).multiply(dy), DIGITS),
      r2.multiply(q0).add(TWO.multiply(r1).multiply(q1)).add(square(a).multiply(square(dy)), DIGITS),
      r2.multiply(q1).round(DIGITS)};
  }

  private static BigDecimal bisect(final BigDecimal[] f, final BigDecimal outside, final BigDecimal inside) {
    BigDecimal out = outside, in = inside;
    for (int i = 0; i < HALVINGS; i++) {
      final BigDecimal middle = out.add(in).multiply(HALF, DIGITS);
      if (at(f, middle).signum() < 0) {
        in = middle;
      } else {
        out = middle;
      }
    }
    return in;
  }

  private static BigDecimal at(final BigDecimal[] f, final BigDecimal t) {
    return f[3].multiply(t).add(f[2]).multiply(t, DIGITS).add(f[1]).multiply(t, DIGITS).add(f[0], DIGITS);
  }

  private static BigDecimal square(final BigDecimal x) {
    return x.multiply(x, DIGITS);
  }
}
