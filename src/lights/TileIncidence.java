package lights;

/**
 * The light that a {@link Light} sends to the points of a tile: for each what an {@link Incidence} holds, as arrays, so that
 * the lights of this package compute it in loops that the compiler turns into vector instructions. Renderers keep one for
 * each thread. Mutable, for one thread at a time.
 */
public final class TileIncidence {

  private final boolean[] lit;
  private final double[] r;
  private final double[] g;
  private final double[] b;
  private final double[] x;
  private final double[] y;
  private final double[] z;
  private final double[] distance;
  private final Incidence single = new Incidence();

  /**
   * No light yet.
   *
   * @param most greatest number of points
   */
  public TileIncidence(final int most) {
    this.lit = new boolean[most];
    this.r = new double[most];
    this.g = new double[most];
    this.b = new double[most];
    this.x = new double[most];
    this.y = new double[most];
    this.z = new double[most];
    this.distance = new double[most];
  }

  /** Asks a light about each point by itself. */
  void ask(final Light light, final int n, final double[] px, final double[] py, final double[] pz) {
    for (int i = 0; i < n; i++) {
      lit[i] = light.illuminate(px[i], py[i], pz[i], single);
      r[i] = single.irradianceR();
      g[i] = single.irradianceG();
      b[i] = single.irradianceB();
      x[i] = single.directionX();
      y[i] = single.directionY();
      z[i] = single.directionZ();
      distance[i] = single.distance();
    }
  }

  /**
   * Computes the light of a point that shines equally in all directions, with the operations of
   * {@link Omnidirectional#illuminate(double, double, double, Incidence)}.
   */
  void radiate(final double sx, final double sy, final double sz, final double red, final double green, final double blue,
      final int n, final double[] px, final double[] py, final double[] pz) {
    aim(n, sx, px, x);
    aim(n, sy, py, y);
    aim(n, sz, pz, z);
    bringToUnit(n, x, y, z, distance);
    spread(n, red, distance, r);
    spread(n, green, distance, g);
    spread(n, blue, distance, b);
    for (int i = 0; i < n; i++) {
      lit[i] = distance[i] > 0 && distance[i] < Double.POSITIVE_INFINITY;
    }
  }

  private static void aim(final int n, final double s, final double[] p, final double[] v) {
    for (int i = 0; i < n; i++) {
      v[i] = s - p[i];
    }
  }

  private static void bringToUnit(final int n, final double[] x, final double[] y, final double[] z, final double[] length) {
    for (int i = 0; i < n; i++) {
      final double d = Math.sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
      x[i] = x[i] / d;
      y[i] = y[i] / d;
      z[i] = z[i] / d;
      length[i] = d;
    }
  }

  private static void spread(final int n, final double power, final double[] distance, final double[] irradiance) {
    for (int i = 0; i < n; i++) {
      irradiance[i] = Math.min(Light.LARGEST, power / (4 * Math.PI * distance[i] * distance[i]));
    }
  }

  /**
   * Whether a point is lit.
   *
   * @param i number of the point
   * @return false if it lies outside of the light's field: then the other numbers mean nothing
   */
  public boolean isLit(final int i) {
    return lit[i];
  }

  /**
   * Red irradiance perpendicular to the incidence.
   *
   * @param i number of the point
   * @return the number, at least 0
   */
  public double irradianceR(final int i) {
    return r[i];
  }

  /**
   * Green irradiance.
   *
   * @param i number of the point
   * @return the number, at least 0
   */
  public double irradianceG(final int i) {
    return g[i];
  }

  /**
   * Blue irradiance.
   *
   * @param i number of the point
   * @return the number, at least 0
   */
  public double irradianceB(final int i) {
    return b[i];
  }

  /**
   * First component of the unit vector from a point towards the light.
   *
   * @param i number of the point
   * @return the number
   */
  public double directionX(final int i) {
    return x[i];
  }

  /**
   * Second component of that vector.
   *
   * @param i number of the point
   * @return the number
   */
  public double directionY(final int i) {
    return y[i];
  }

  /**
   * Third component of that vector.
   *
   * @param i number of the point
   * @return the number
   */
  public double directionZ(final int i) {
    return z[i];
  }

  /**
   * Distance to where the light comes from.
   *
   * @param i number of the point
   * @return the distance in scene units, &gt; 0
   */
  public double distance(final int i) {
    return distance[i];
  }
}
