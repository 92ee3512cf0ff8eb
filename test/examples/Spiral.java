package examples;

import static examples.Numbers.cos;
import static examples.Numbers.sin;
import static examples.Numbers.text;
import static examples.Numbers.triple;

/**
 * Balls as a sunflower sets its seeds: each a golden angle further round than the one before, and at such a distance that
 * all have the same space (H. Vogel, "A better way to construct the sunflower head", Mathematical Biosciences 44, 1979).
 */
final class Spiral {

  private static final int BALLS = 800;
  private static final double GOLDEN_ANGLE = 137.50776405;
  private static final int[][] COLOURS =
      {{255, 246, 196}, {255, 200, 70}, {250, 130, 60}, {214, 51, 90}, {120, 30, 120}, {48, 22, 92}};

  private Spiral() {
  }

  /** The text of the file. */
  static String scene() {
    final SceneText scene = new SceneText("sunflower", """
        Eight hundred balls, set as a sunflower sets its seeds: each 137.5 degrees further round than the one before.
        All are the same model, a ball of radius 1: scaleFactors gives each its size, color its colour.
        Written by test/examples/Spiral.java.
        """)
        .raster(800, 800, "14 8 26", true)
        .camera("0 29 22", "0 0.2 1.2", "0 1 0")
        .projection("perspective", "fov", "37")
        .model("ball", "sphere", "radius", "1");
    for (int i = 0; i < BALLS; i++) {
      final double share = (i + 0.5) / BALLS;
      final double out = 11.6 * Math.sqrt(share);
      final double size = thousandths(0.27 + 0.17 * Math.sqrt(share));
      final double height = 4.2 * (1 - share) * (1 - share);
      scene.object("ball", SceneText.scale(Math.sqrt(share), COLOURS),
          "translation", triple(out * cos(i * GOLDEN_ANGLE), height, out * sin(i * GOLDEN_ANGLE)),
          "scaleFactors", triple(size, size, size));
    }
    return scene.toString();
  }

  private static double thousandths(final double x) {
    return Double.parseDouble(text(x, 3));
  }
}
