package materials;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * The formulas of lobes with the {@link GGX} distribution as they stand in the specification, in BigDecimal: square roots
 * are the only functions needed.
 */
final class ExactMaterials {

  private static final MathContext MC = new MathContext(60);
  private static final BigDecimal ONE = BigDecimal.ONE;
  private static final BigDecimal TWO = BigDecimal.valueOf(2);
  private static final BigDecimal FOUR = BigDecimal.valueOf(4);
  private static final BigDecimal PI = new BigDecimal("3.14159265358979323846264338327950288419716939937510582097494");

  private final BigDecimal[] wi;
  private final BigDecimal[] wo;
  private final BigDecimal[] n;
  private final BigDecimal ci;
  private final BigDecimal co;
  private final BigDecimal alpha2;

  ExactMaterials(final double[] wi, final double[] wo, final double[] n, final double beta) {
    this.wi = unit(exact(wi));
    this.wo = unit(exact(wo));
    this.n = unit(exact(n));
    this.ci = dot(this.n, this.wi).abs();
    this.co = dot(this.n, this.wo);
    final BigDecimal sine = new BigDecimal(Math.sin(Math.toRadians(beta))), sine2 = sine.multiply(sine, MC);
    this.alpha2 = sine2.divide(TWO.sqrt(MC).subtract(ONE.subtract(sine2), MC), MC);
  }

  private static BigDecimal[] exact(final double... v) {
    return new BigDecimal[] {new BigDecimal(v[0]), new BigDecimal(v[1]), new BigDecimal(v[2])};
  }

  private static BigDecimal dot(final BigDecimal[] a, final BigDecimal[] b) {
    return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2])).round(MC);
  }

  private static BigDecimal[] unit(final BigDecimal[] v) {
    final BigDecimal length = dot(v, v).sqrt(MC);
    return new BigDecimal[] {v[0].divide(length, MC), v[1].divide(length, MC), v[2].divide(length, MC)};
  }

  private static BigDecimal[] sum(final BigDecimal a, final BigDecimal[] v, final BigDecimal b, final BigDecimal[] w) {
    final BigDecimal[] sum = new BigDecimal[3];
    for (int i = 0; i < 3; i++) {
      sum[i] = a.multiply(v[i]).add(b.multiply(w[i]));
    }
    return sum;
  }

  private BigDecimal density(final BigDecimal nh) {
    final BigDecimal cosine2 = nh.multiply(nh, MC), d = alpha2.multiply(cosine2).add(ONE).subtract(cosine2);
    return alpha2.divide(PI.multiply(d).multiply(d), MC);
  }

  private static BigDecimal fifth(final BigDecimal c) {
    return ONE.subtract(c).pow(5, MC);
  }

  /** G = min(1, 2 (n·h) co / |wo·h|, 2 (n·h) ci / |wi·h|). */
  private BigDecimal masking(final BigDecimal nh, final BigDecimal hi, final BigDecimal ho) {
    return ONE.min(TWO.multiply(nh).multiply(co).divide(ho, MC)).min(TWO.multiply(nh).multiply(ci).divide(hi, MC));
  }

  /** D(h) (n·h) / (4 c max(ci, co)). */
  private BigDecimal mirrored(final BigDecimal nh, final BigDecimal c) {
    return density(nh).multiply(nh).divide(FOUR.multiply(c).multiply(ci.max(co)), MC);
  }

  double phong(final double kd, final double ks) {
    final BigDecimal[] h = unit(sum(ONE, wi, ONE, wo));
    return new BigDecimal(kd).divide(PI, MC).add(new BigDecimal(ks).multiply(mirrored(dot(n, h), dot(wo, h)))).doubleValue();
  }

  double ashikhmin(final double kd, final double ks) {
    final BigDecimal[] h = unit(sum(ONE, wi, ONE, wo));
    final BigDecimal c = dot(wo, h), s = new BigDecimal(ks);
    final BigDecimal below = new BigDecimal(28).divide(new BigDecimal(23).multiply(PI), MC).multiply(new BigDecimal(kd))
        .multiply(ONE.subtract(s)).multiply(ONE.subtract(fifth(ci.divide(TWO))))
        .multiply(ONE.subtract(fifth(co.divide(TWO))));
    final BigDecimal fresnel = s.add(ONE.subtract(s).multiply(fifth(c)));
    return below.add(fresnel.multiply(mirrored(dot(n, h), c))).doubleValue();
  }

  double cookTorrance(final double kd, final double ks) {
    final BigDecimal[] h = unit(sum(ONE, wi, ONE, wo));
    final BigDecimal c = dot(wo, h), nh = dot(n, h), d = new BigDecimal(kd), s = new BigDecimal(ks);
    final BigDecimal fresnel = s.add(ONE.subtract(d).subtract(s).multiply(fifth(c)));
    return d.divide(PI, MC).add(fresnel.multiply(cavities(nh, c))).doubleValue();
  }

  private BigDecimal cavities(final BigDecimal nh, final BigDecimal c) {
    return density(nh).multiply(masking(nh, c, c)).divide(FOUR.multiply(ci).multiply(co), MC);
  }

  /** Unpolarised Fresnel reflectance. */
  static BigDecimal fresnel(final BigDecimal cosine, final BigDecimal etaO, final BigDecimal etaT) {
    final BigDecimal ratio = etaO.divide(etaT, MC);
    final BigDecimal square = ONE.subtract(ratio.multiply(ratio).multiply(ONE.subtract(cosine.multiply(cosine))), MC);
    if (square.signum() < 0) {
      return ONE;
    }
    final BigDecimal t = square.sqrt(MC);
    final BigDecimal s = etaO.multiply(cosine).subtract(etaT.multiply(t))
        .divide(etaO.multiply(cosine).add(etaT.multiply(t)), MC);
    final BigDecimal p = etaT.multiply(cosine).subtract(etaO.multiply(t))
        .divide(etaT.multiply(cosine).add(etaO.multiply(t)), MC);
    return s.multiply(s).add(p.multiply(p)).divide(TWO, MC);
  }

  double glassReflection(final double etaO, final double etaT) {
    final BigDecimal[] h = unit(sum(ONE, wi, ONE, wo));
    final BigDecimal c = dot(wo, h);
    return fresnel(c, new BigDecimal(etaO), new BigDecimal(etaT)).multiply(cavities(dot(n, h), c)).doubleValue();
  }

  double glassTransmission(final double etaO, final double etaT) {
    final BigDecimal o = new BigDecimal(etaO), t = new BigDecimal(etaT);
    final BigDecimal[] any = unit(sum(t, wi, o, wo));
    final BigDecimal sign = BigDecimal.valueOf(dot(n, any).signum());
    final BigDecimal nh = dot(n, any).multiply(sign), hi = dot(wi, any).multiply(sign), ho = dot(wo, any).multiply(sign);
    if (ho.signum() <= 0 || hi.signum() >= 0) {
      return 0;
    }
    final BigDecimal d = t.multiply(hi).add(o.multiply(ho));
    return hi.abs().multiply(ho).multiply(o).multiply(o).multiply(ONE.subtract(fresnel(ho, o, t))).multiply(density(nh))
        .multiply(masking(nh, hi.abs(), ho)).divide(ci.multiply(co).multiply(d).multiply(d), MC).doubleValue();
  }
}
