package materials;

import static arguments.Arguments.direction;
import static arguments.Arguments.within;

import primitives.Vector3D;

/**
 * How the normals of the microfacets of a rough surface are distributed about its own: D(θ) per steradian, θ being the
 * angle between the surface's normal n and the microfacets' normal h. It is normalised, ∫ D(h) (n·h) dω = 1 over the
 * hemisphere about n. Immutable.
 *
 * <p>The width β is the angle between n and h at which D has half of its peak (Blinn, "Models of light reflection for
 * computer synthesized pictures", SIGGRAPH 1977). For β less than 0.1 degrees the surface counts as polished: the lobe
 * of a material is its limit, ideal reflection.
 */
public abstract class NormalDistributionFunction {

  private static final float POLISHED = 0.1f;

  private final float beta;

  /**
   * A distribution.
   *
   * @param beta angle of half value in degrees, from 0 to 90
   * @throws IllegalArgumentException if beta is outside, or NaN
   */
  protected NormalDistributionFunction(final float beta) {
    this.beta = within("beta", 0f, 90f, beta);
  }

  /**
   * The density of microfacets of a direction.
   *
   * @param cosine cos θ = n·h, &gt; 0
   * @param sine2 sin² θ = |n × h|²; given as well because near n it cannot be computed from the cosine
   * @return D(θ) per steradian, at least 0
   */
  protected abstract double density(double cosine, double sine2);

  /**
   * The density of microfacets of a direction, D.
   *
   * @param n normal of the surface
   * @param h normal of the microfacets
   * @return D per steradian; 0 where n·h ≤ 0, and for a polished surface, whose density is not finite
   * @throws IllegalArgumentException if a vector is null, zero, or not finite
   */
  public final double getProbability(final Vector3D n, final Vector3D h) {
    direction("n", n);
    direction("h", h);
    final double nx = n.x, ny = n.y, nz = n.z, hx = h.x, hy = h.y, hz = h.z;
    final double lengths2 = (nx * nx + ny * ny + nz * nz) * (hx * hx + hy * hy + hz * hz);
    final double cx = ny * hz - nz * hy, cy = nz * hx - nx * hz, cz = nx * hy - ny * hx;
    final double cosine = (nx * hx + ny * hy + nz * hz) / Math.sqrt(lengths2);
    return isPolished() || !(cosine > 0) ? 0 : density(cosine, (cx * cx + cy * cy + cz * cz) / lengths2);
  }

  /**
   * The width β.
   *
   * @return angle of half value in degrees, from 0 to 90
   */
  public final float getBeta() {
    return beta;
  }

  /**
   * Whether the lobe is so narrow that it counts as ideal reflection.
   *
   * @return true if β is less than 0.1 degrees
   */
  public final boolean isPolished() {
    return beta < POLISHED;
  }

  /** The squared sine of an angle in degrees. */
  static double sine2(final double degrees) {
    final double sine = Math.sin(Math.toRadians(degrees));
    return sine * sine;
  }

  @Override
  public String toString() {
    return getClass().getSimpleName() + "(" + beta + ")";
  }
}
