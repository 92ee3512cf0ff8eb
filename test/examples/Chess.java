package examples;

import static examples.Numbers.cos;
import static examples.Numbers.sin;
import static examples.Numbers.triple;

/** A chess board with the last position of a game. Each piece is a small stack of shapes. */
final class Chess {

  /** The Immortal Game, Anderssen against Kieseritzky, London 1851: mate (in Forsyth's notation: ranks 8 to 1). */
  private static final String POSITION = "r1bk3r/p2pBpNp/n4n2/1p1NP2P/6P1/3P4/P1P1K3/q5b1";

  /** Colours or materials: of the white and the black pieces, the light and the dark squares, and the frame. */
  private static final String[] COLOURS = {"255 244 220", "196 62 58", "232 208 168", "150 104 74", "70 46 40"};
  private static final String[] MATERIALS = {"ivory", "rosewood", "maple", "walnut", "ebony"};

  private final SceneText scene;
  private final String[] looks;

  private Chess(final SceneText scene, final String... looks) {
    this.scene = scene;
    this.looks = looks;
  }

  /** The position in plain colours. */
  static String text() {
    final SceneText scene = new SceneText("chess", """
        The Immortal Game (Anderssen against Kieseritzky, London 1851) after its last move: White has given a bishop, both
        rooks and the queen, and it is mate.
        Each piece is a stack of shapes in one colour. They may overlap: a ray hits whichever is nearest.
        Written by test/examples/Chess.java.
        """)
        .raster(900, 720, "38 44 56", true)
        .camera("4.6 8 10", "0.1 0.1 0.4", "0 1 0")
        .projection("perspective", "fov", "40", "aspect", "1.25");
    return new Chess(scene, COLOURS).built();
  }

  /** The position by lamplight, on a polished board. */
  static String lit() {
    final String conductive = "conductiveReflectance", diffuse = "diffuseReflectance";
    final SceneText scene = new SceneText("chess on a polished board", """
        The position of chess.xml by lamplight. The pieces are varnished, the board is polished: with beta 0 its highlights
        become mirror images, stronger where one looks along the board.
        The main lamp hangs low at the left, so that shadows are long; a weak one in front brightens them.
        Written by test/examples/Chess.java.
        """)
        .litRaster(900, 720, "16 19 27", 3)
        .camera("4.7 7.2 10.4", "0 0.1 0.5", "0 1 0")
        .projection("perspective", "fov", "41", "aspect", "1.25")
        .light("omnidirectional", "spectrum", "0.375 0.335 0.29", "power", "640", "position", "-8 7.5 3")
        .light("omnidirectional", "spectrum", "0.31 0.335 0.355", "power", "190", "position", "7 7 9")
        .brdf("ivory", "Ashikhmin-Shirley", diffuse, "0.75 0.68 0.52", conductive, "0.05 0.05 0.05", "ndf", "GGX",
            "beta", "8")
        .brdf("rosewood", "Ashikhmin-Shirley", diffuse, "0.42 0.05 0.04", conductive, "0.06 0.06 0.06", "ndf", "GGX",
            "beta", "8")
        .brdf("maple", "Ashikhmin-Shirley", diffuse, "0.66 0.5 0.3", conductive, "0.05 0.05 0.05", "beta", "0")
        .brdf("walnut", "Ashikhmin-Shirley", diffuse, "0.2 0.09 0.045", conductive, "0.05 0.05 0.05", "beta", "0")
        .brdf("ebony", "Ashikhmin-Shirley", diffuse, "0.05 0.035 0.03", conductive, "0.05 0.05 0.05", "beta", "0");
    return new Chess(scene, MATERIALS).built();
  }

  private String built() {
    models();
    board();
    int rank = 7;
    for (final String row : POSITION.split("/")) {
      int file = 0;
      for (final char c : row.toCharArray()) {
        if (Character.isDigit(c)) {
          file += c - '0';
        } else {
          piece(c, file++ - 3.5, 3.5 - rank);
        }
      }
      rank--;
    }
    return scene.toString();
  }

  private void models() {
    scene.model("frame", "box", "width", "9", "height", "0.3", "depth", "9")
        .model("square", "box", "width", "1", "height", "0.2", "depth", "1")
        .model("foot", "cylinder", "radius", "0.34", "Axislength", "0.12")
        .model("ring", "torus", "rotationalRadius", "0.2", "circunferenceRadius", "0.07")
        .model("body", "ellipsoid", "a", "0.22", "b", "0.5", "c", "0.22")
        .model("tower", "cylinder", "radius", "0.22", "Axislength", "0.7")
        .model("platform", "cylinder", "radius", "0.3", "Axislength", "0.16")
        .model("battlement", "box", "width", "0.14", "height", "0.14", "depth", "0.14")
        .model("neck", "capsule", "A", "0 0 0", "B", "0 0.5 0", "radius", "0.19")
        .model("muzzle", "capsule", "A", "0 0 0", "B", "0 0.3 0", "radius", "0.13")
        .model("ball", "sphere", "radius", "0.2")
        .model("cross", "box", "width", "0.08", "height", "0.3", "depth", "0.08");
  }

  private void board() {
    scene.object("frame", looks[4], "translation", "0 -0.22 0");
    for (int file = 0; file < 8; file++) {
      for (int rank = 0; rank < 8; rank++) {
        final boolean dark = (file + rank) % 2 == 0;
        scene.object("square", looks[dark ? 3 : 2], "translation", triple(file - 3.5, -0.1, 3.5 - rank));
      }
    }
  }

  private void piece(final char kind, final double x, final double z) {
    final String look = looks[Character.isUpperCase(kind) ? 0 : 1];
    part("foot", look, x, 0.06, z, 1, 1, 1);
    part("ring", look, x, 0.15, z, 1.2, 1, 1.2);
    switch (Character.toLowerCase(kind)) {
      case 'p' -> pawn(look, x, z);
      case 'r' -> rook(look, x, z);
      case 'n' -> knight(look, x, z);
      case 'b' -> bishop(look, x, z);
      case 'q' -> queen(look, x, z);
      default -> king(look, x, z);
    }
  }

  private void pawn(final String look, final double x, final double z) {
    part("body", look, x, 0.3, z, 0.85, 0.7, 0.85);
    part("ring", look, x, 0.56, z, 0.75, 0.6, 0.75);
    part("ball", look, x, 0.72, z, 0.95, 0.95, 0.95);
  }

  private void rook(final String look, final double x, final double z) {
    part("tower", look, x, 0.45, z, 1, 1, 1);
    part("platform", look, x, 0.82, z, 1, 1, 1);
    for (int i = 0; i < 6; i++) {
      scene.object("battlement", look, "rotationAngle", Numbers.text(-60.0 * i, 0),
          "translation", triple(x + 0.22 * cos(60.0 * i), 0.95, z + 0.22 * sin(60.0 * i)));
    }
  }

  /** A neck that leans forward, a muzzle that points forward and down, two ears; White looks to the far side. */
  private void knight(final String look, final double x, final double z) {
    final int forward = look.equals(looks[0]) ? -1 : 1;
    scene.object("neck", look, "translation", triple(x, 0.25, z - 0.06 * forward),
        "jVector", triple(0, 1, 0.12 * forward), "iauxVector", "1 0 0", "scaleFactors", "0.95 1.15 1.15");
    scene.object("muzzle", look, "translation", triple(x, 0.92, z - 0.02 * forward),
        "jVector", triple(0, -0.45, forward), "iauxVector", "1 0 0");
    for (int side = -1; side <= 1; side += 2) {
      part("body", look, x + 0.09 * side, 1.06, z - 0.06 * forward, 0.2, 0.26, 0.24);
    }
  }

  private void bishop(final String look, final double x, final double z) {
    part("body", look, x, 0.45, z, 0.85, 1, 0.85);
    part("ring", look, x, 0.82, z, 0.8, 0.7, 0.8);
    part("body", look, x, 1.06, z, 0.75, 0.5, 0.75);
    part("ball", look, x, 1.33, z, 0.32, 0.32, 0.32);
  }

  private void queen(final String look, final double x, final double z) {
    part("body", look, x, 0.55, z, 0.95, 1.3, 0.95);
    part("ring", look, x, 1.05, z, 0.85, 0.8, 0.85);
    part("ring", look, x, 1.3, z, 1.05, 1.2, 1.05);
    part("ball", look, x, 1.34, z, 0.7, 0.9, 0.7);
    for (int i = 0; i < 8; i++) {
      part("ball", look, x + 0.23 * cos(45.0 * i), 1.4, z + 0.23 * sin(45.0 * i), 0.3, 0.3, 0.3);
    }
    part("ball", look, x, 1.56, z, 0.4, 0.4, 0.4);
  }

  private void king(final String look, final double x, final double z) {
    part("body", look, x, 0.55, z, 0.95, 1.3, 0.95);
    part("ring", look, x, 1.08, z, 0.85, 0.8, 0.85);
    part("platform", look, x, 1.3, z, 0.75, 1.5, 0.75);
    part("ball", look, x, 1.42, z, 1, 0.5, 1);
    part("cross", look, x, 1.65, z, 1, 1.2, 1);
    part("cross", look, x, 1.69, z, 3.2, 0.28, 1);
  }

  private void part(final String model, final String look, final double x, final double y, final double z,
      final double width, final double height, final double depth) {
    if (width == 1 && height == 1 && depth == 1) {
      scene.object(model, look, "translation", triple(x, y, z));
    } else {
      scene.object(model, look, "translation", triple(x, y, z), "scaleFactors", triple(width, height, depth));
    }
  }
}
