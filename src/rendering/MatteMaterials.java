package rendering;

import java.awt.Color;

import materials.Lambertian;
import materials.Material;
import radiometry.ReflectanceRGB;

/** A cache of the matte materials of colours, as decoding a colour takes three powers. One for each thread. */
final class MatteMaterials {

  private static final int SIZE = 256;

  private final int[] colours = new int[SIZE];
  private final Material[] materials = new Material[SIZE];

  /** The matte material of a colour; alpha is ignored. */
  Material of(final Color color) {
    final int rgb = color.getRGB(), place = (rgb * 0x9E3779B1) >>> 24;
    if (materials[place] == null || colours[place] != rgb) {
      materials[place] = new Lambertian(new ReflectanceRGB(color));
      colours[place] = rgb;
    }
    return materials[place];
  }
}
