package materials;

import java.awt.Color;

import radiometry.ReflectanceRGB;

/** The colours of materials where there is no illumination: the sum of the reflectances, not encoded. */
final class StandIn {

  private StandIn() {
  }

  static Color of(final ReflectanceRGB... reflectances) {
    float r = 0, g = 0, b = 0;
    for (final ReflectanceRGB k : reflectances) {
      r += k == null ? 0 : k.getR();
      g += k == null ? 0 : k.getG();
      b += k == null ? 0 : k.getB();
    }
    return new Color(component(r), component(g), component(b));
  }

  private static int component(final float sum) {
    return (int) Math.min(255, Math.floor(255.0 * sum + 0.5));
  }
}
