package rendering;

import models.Object3D;
import models.TileHits;
import tracer.Hit;
import tracer.Ray;

/** Writes the colours of a shading, on a background. */
class ColourWriter implements PixelWriter {

  private final Shading shading;
  private final int[] pixels;
  private final int background;

  /** A writer into an array of sRGB with alpha, the top row first. */
  ColourWriter(final Shading shading, final int[] pixels, final int background) {
    this.shading = shading;
    this.pixels = pixels;
    this.background = background;
  }

  @Override
  public void hit(final int pixel, final Ray ray, final Hit hit) {
    pixels[pixel] = shading.argb(ray, hit);
  }

  @Override
  public void miss(final int pixel, final Ray ray) {
    pixels[pixel] = background;
  }

  /** Whether pixels have the plain colours of the objects, for which no hit needs to be made. */
  boolean isPlain() {
    return shading == Shading.PLAIN;
  }

  /** Working space for the light of a tile; null for other shadings. */
  LitTile litTile() {
    return shading instanceof Illumination illumination ? new LitTile(illumination) : null;
  }

  /** Writes the plain colours of what some rays of a row of a tile hit, from a place on. */
  void paint(final int at, final TileHits hits, final int first, final int width) {
    hits.paint(first, width, pixels, at, background);
  }

  /** Writes the light that ray i of a tile brings from what it hits. */
  void paint(final int pixel, final TileHits hits, final int i, final LitTile lit) {
    pixels[pixel] = lit.argb(i);
  }

  /** Writes the colour of a hit with an object of the scene. */
  void hit(final int pixel, final Ray ray, final Hit hit, final Object3D object) {
    hit(pixel, ray, hit);
  }

  @Override
  public String toString() {
    return shading.getClass().getName();
  }
}
