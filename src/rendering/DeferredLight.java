package rendering;

import acceleration.RayTile;
import materials.Material;
import radiometry.RadianceRGB;
import tracer.Hit;
import tracer.Ray;

/**
 * The light of reflected and refracted rays for the pixels of a tile. The surfaces that they see are kept until there are
 * enough of them, and then lit together. Rays that see the background are kept as well, as a pixel's sum is taken in the
 * order in which {@link WhittedTracer} follows its rays. One for each thread.
 */
final class DeferredLight {

  private static final int MOST = 2 * TileSurfaces.MOST;

  private final RadianceRGB background;
  private final TileSurfaces surfaces = new TileSurfaces();
  private final DirectLight light;

  /** For each ray its pixel, its weight, and the number of the surface that it sees; −1 for the background. */
  private final int[] pixels = new int[MOST];
  private final double[] weightR = new double[MOST];
  private final double[] weightG = new double[MOST];
  private final double[] weightB = new double[MOST];
  private final int[] numbers = new int[MOST];
  private int count;

  private final double[] r = new double[RayTile.SIZE * RayTile.SIZE];
  private final double[] g = new double[RayTile.SIZE * RayTile.SIZE];
  private final double[] b = new double[RayTile.SIZE * RayTile.SIZE];

  /** The pixel whose rays are followed. */
  private int pixel;

  DeferredLight(final Illumination illumination) {
    this.background = illumination.backgroundRadiance();
    this.light = new DirectLight(illumination, surfaces);
  }

  /** Sets the pixel whose rays come next, and the contribution of the lights to the surface that its own ray sees. */
  void begin(final int itsPixel, final double lr, final double lg, final double lb) {
    pixel = itsPixel;
    r[pixel] = lr;
    g[pixel] = lg;
    b[pixel] = lb;
  }

  /** Keeps the surface of a hit, whose material scatters, for the light that it sends along a ray of some weight. */
  void add(final Ray ray, final Hit hit, final ViewedSurface viewed, final Material material,
      final double wr, final double wg, final double wb) {
    final int number = surfaces.count();
    surfaces.add(ray, hit, viewed, material);
    add(number, wr, wg, wb);
  }

  /** Keeps a ray that sees the background. */
  void addBackground(final double wr, final double wg, final double wb) {
    add(-1, wr, wg, wb);
  }

  private void add(final int number, final double wr, final double wg, final double wb) {
    pixels[count] = pixel;
    weightR[count] = wr;
    weightG[count] = wg;
    weightB[count] = wb;
    numbers[count++] = number;
    if (count == MOST || surfaces.count() == TileSurfaces.MOST) {
      find();
    }
  }

  /** Computes the light of all that is kept. */
  void find() {
    light.find();
    for (int i = 0; i < count; i++) {
      final int k = numbers[i], p = pixels[i];
      r[p] += weightR[i] * (k < 0 ? background.getR() : light.r(k));
      g[p] += weightG[i] * (k < 0 ? background.getG() : light.g(k));
      b[p] += weightB[i] * (k < 0 ? background.getB() : light.b(k));
    }
    surfaces.clear();
    count = 0;
  }

  /** Red radiance of a pixel, once {@link #find} was called. */
  double r(final int itsPixel) {
    return r[itsPixel];
  }

  double g(final int itsPixel) {
    return g[itsPixel];
  }

  double b(final int itsPixel) {
    return b[itsPixel];
  }
}
