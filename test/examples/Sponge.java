package examples;

import static examples.Numbers.triple;

/** A sponge after Karl Menger: a cube without its middle and the middles of its faces, made of such cubes, made of cubes. */
final class Sponge {

  private static final int SIDE = 9;

  private Sponge() {
  }

  /** The text of the file. */
  static String scene() {
    final SceneText scene = new SceneText("Menger sponge", """
        A cube loses its middle and the middles of its six faces; each of the 20 cubes that are left loses the same.
        What remains are 400 boxes, all of one model; their colours say where they are:
        red grows along X, green along Y, blue along Z.
        Written by test/examples/Sponge.java.
        """)
        .raster(800, 800, "16 17 26", true)
        .camera("13.4 13.6 16.8", "0.1 -0.5 0", "0 1 0")
        .projection("perspective", "fov", "34")
        .model("cube", "box", "width", "1", "height", "1", "depth", "1");
    for (int x = 0; x < SIDE; x++) {
      for (int y = 0; y < SIDE; y++) {
        for (int z = 0; z < SIDE; z++) {
          if (!isHole(x % 3, y % 3, z % 3) && !isHole(x / 3, y / 3, z / 3)) {
            scene.object("cube", colour(x, y, z), "translation", triple(x - 4, y - 4, z - 4));
          }
        }
      }
    }
    return scene.toString();
  }

  private static boolean isHole(final int x, final int y, final int z) {
    return (x == 1 ? 1 : 0) + (y == 1 ? 1 : 0) + (z == 1 ? 1 : 0) >= 2;
  }

  /** Red grows along X, green along Y, blue along Z. */
  private static String colour(final int x, final int y, final int z) {
    return Math.round(45 + 210.0 * x / 8) + " " + Math.round(60 + 195.0 * y / 8) + " " + Math.round(70 + 185.0 * z / 8);
  }
}
