package inspection;

import radiometry.RadianceRGB;

/**
 * The light of a pixel in a lit scene.
 *
 * @param root the surface that the ray of the pixel hits
 * @param radiance the radiance L of the pixel, which is the sum of all contributions in the tree
 * @param exposure exposure of the picture in stops; the pixel shows 10 · 2<sup>exposure</sup> · L
 * @param recursionDepth greatest depth of a ray
 */
public record PixelLight(LightNode root, RadianceRGB radiance, double exposure, int recursionDepth) {

  /**
   * The factor between radiance and the linear value of the pixel.
   *
   * @return 10 · 2<sup>exposure</sup>
   */
  public double gain() {
    return 10 * Math.pow(2, exposure);
  }
}
