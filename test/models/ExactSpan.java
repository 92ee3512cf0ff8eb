package models;

import static models.ExactVector.DIGITS;

import java.math.BigDecimal;

import tracer.Ray;

/**
 * The part of a ray's line within a convex solid, computed in decimals of 50 digits straight from the definitions: the
 * oracle of the shapes that have a closed form. The line is that of the ray's floats, with normalised direction.
 *
 * @param enter parameter of the first point, null if unbounded
 * @param leave parameter of the last point, null if unbounded
 * @param gap how far the line misses or enters the solid, relative to the solid's least size: positive inside
 */
record ExactSpan(BigDecimal enter, BigDecimal leave, double gap) {

  /** A line as the oracle sees it. */
  record Line(ExactVector start, ExactVector direction) {

    static Line exactly(final Ray ray) {
      return new Line(ExactVector.of(ray.startX(), ray.startY(), ray.startZ()),
          ExactVector.of(ray.directionX(), ray.directionY(), ray.directionZ()).normalised());
    }

    static Line of(final Ray ray) {
      return new Line(ExactVector.of(ray.getStartingPoint()), ExactVector.of(ray.getDirection()).normalised());
    }
  }

  static final ExactSpan ALL = new ExactSpan(null, null, Double.POSITIVE_INFINITY);

  private static final ExactSpan NONE_BY_FAR = new ExactSpan(BigDecimal.ONE, BigDecimal.ZERO, Double.NEGATIVE_INFINITY);

  /** The ball |P − C| ≤ r. */
  static ExactSpan ball(final Line line, final ExactVector C, final BigDecimal r) {
    return round(line.direction, C.minus(line.start), r);
  }

  /** The infinite cylinder about the axis C + s û. */
  static ExactSpan cylinder(final Line line, final ExactVector C, final ExactVector u, final BigDecimal r) {
    final ExactVector l = C.minus(line.start), d = line.direction;
    return round(d.minus(u.times(d.dot(u))), l.minus(u.times(l.dot(u))), r);
  }

  /** |t d − l| ≤ r: a t² − 2 b t + c ≤ 0. */
  private static ExactSpan round(final ExactVector d, final ExactVector l, final BigDecimal r) {
    final BigDecimal a = d.dot(d), b = l.dot(d), c = l.dot(l).subtract(r.multiply(r));
    if (a.doubleValue() < 1e-100) {
      return c.signum() <= 0 ? ALL : NONE_BY_FAR;
    }
    final BigDecimal discriminant = b.multiply(b).subtract(a.multiply(c), DIGITS);
    final double gap = discriminant.divide(a.multiply(r).multiply(r), DIGITS).doubleValue();
    if (discriminant.signum() < 0) {
      return new ExactSpan(BigDecimal.ONE, BigDecimal.ZERO, gap);
    }
    final BigDecimal root = ExactVector.root(discriminant);
    return new ExactSpan(b.subtract(root).divide(a, DIGITS), b.add(root).divide(a, DIGITS), gap);
  }

  /** The slab |(P − C)·n| ≤ h for a unit vector n. */
  static ExactSpan slab(final Line line, final ExactVector C, final ExactVector n, final BigDecimal h) {
    final BigDecimal s = line.start.minus(C).dot(n), d = line.direction.dot(n);
    final double gap = Math.abs(h.subtract(s.abs()).divide(h, DIGITS).doubleValue());
    if (d.abs().doubleValue() < 1e-50) {
      return s.abs().compareTo(h) <= 0 ? new ExactSpan(null, null, gap) : NONE_BY_FAR;
    }
    final BigDecimal one = h.negate().subtract(s).divide(d, DIGITS), other = h.subtract(s).divide(d, DIGITS);
    return new ExactSpan(one.min(other), one.max(other), Double.POSITIVE_INFINITY);
  }

  /**
   * The half of the infinite cone about the axis C + s û whose radius m + k s is positive.
   *
   * @param size a length that the gap is measured by
   */
  static ExactSpan cone(final Line line, final ExactVector C, final ExactVector u, final BigDecimal m, final BigDecimal k,
      final BigDecimal size) {
    final ExactVector o = line.start.minus(C), d = line.direction;
    final BigDecimal s = o.dot(u), ds = d.dot(u), r = m.add(k.multiply(s)), growth = k.multiply(ds);
    final ExactVector across = o.minus(u.times(s)), dAcross = d.minus(u.times(ds));
    final BigDecimal a = dAcross.dot(dAcross).subtract(growth.multiply(growth), DIGITS);
    final BigDecimal b = across.dot(dAcross).subtract(growth.multiply(r), DIGITS);
    final BigDecimal c = across.dot(across).subtract(r.multiply(r), DIGITS);
    final BigDecimal discriminant = b.multiply(b).subtract(a.multiply(c), DIGITS);
    final double gap = discriminant.divide(a.multiply(size).multiply(size), DIGITS).doubleValue();
    if (discriminant.signum() < 0) {
      return new ExactSpan(BigDecimal.ONE, BigDecimal.ZERO, gap);
    }
    final BigDecimal root = ExactVector.root(discriminant);
    final BigDecimal one = b.negate().subtract(root).divide(a, DIGITS), other = b.negate().add(root).divide(a, DIGITS);
    if (a.signum() > 0) {
      final BigDecimal radius = r.subtract(growth.multiply(b).divide(a, DIGITS));
      return radius.signum() >= 0 ? new ExactSpan(one, other, gap)
          : new ExactSpan(BigDecimal.ONE, BigDecimal.ZERO, radius.divide(size, DIGITS).doubleValue());
    }
    return growth.signum() > 0 ? new ExactSpan(one.max(other), null, Double.POSITIVE_INFINITY)
        : new ExactSpan(null, one.min(other), Double.POSITIVE_INFINITY);
  }

  ExactSpan and(final ExactSpan other, final double size) {
    final BigDecimal from = enter == null ? other.enter : other.enter == null ? enter : enter.max(other.enter);
    final BigDecimal to = leave == null ? other.leave : other.leave == null ? leave : leave.min(other.leave);
    final double overlap = from == null || to == null ? Double.POSITIVE_INFINITY : to.subtract(from).doubleValue() / size;
    return new ExactSpan(from, to, Math.min(overlap, Math.min(gap, other.gap)));
  }

  /** The least span with both, if they touch or one is empty: that of a convex union. */
  ExactSpan or(final ExactSpan other) {
    if (isEmpty() || other.isEmpty()) {
      final ExactSpan left = isEmpty() ? other : this;
      return new ExactSpan(left.enter, left.leave, Math.max(gap, other.gap));
    }
    return new ExactSpan(enter == null || other.enter == null ? null : enter.min(other.enter),
        leave == null || other.leave == null ? null : leave.max(other.leave), Math.max(gap, other.gap));
  }

  boolean isEmpty() {
    return enter != null && leave != null && enter.compareTo(leave) > 0;
  }

  /** Distance of the first point of the surface ahead, or infinity. */
  double first() {
    if (isEmpty()) {
      return Double.POSITIVE_INFINITY;
    }
    return enter != null && enter.signum() > 0 ? enter.doubleValue()
        : leave != null && leave.signum() > 0 ? leave.doubleValue() : Double.POSITIVE_INFINITY;
  }
}
