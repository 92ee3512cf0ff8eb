package examples;

import static examples.Numbers.cos;
import static examples.Numbers.sin;
import static examples.Numbers.triple;

import java.util.Random;

/** A double helix, after that of DNA: ten and a half pairs a turn, and the two strands not opposite to each other. */
final class Helix {

  private static final int PAIRS = 46;
  private static final double TURN = 360 / 10.5;
  private static final double RISE = 0.62;
  private static final double RADIUS = 2.1;
  /** Angle from one strand to the other, which leaves a narrow groove and a wide one. */
  private static final double GROOVE = 150;
  private static final String STRAND = "236 238 245";
  private static final String[] BASES = {"242 95 76", "255 196 77", "72 149 239", "76 201 160"};

  private final SceneText scene = new SceneText("double helix", """
      A double helix of balls (sphere) and sticks (capsule).
      A stick of the model "bond" lies on the Y axis and is 1 long. An object lays it between two points: scaleFactors
      stretches it along Y, then jVector says where its Y axis goes, then translation moves its middle to its place.
      (jVector needs a second direction that says how the model turns about it: iauxVector or kauxVector.)
      Stretched ends of a capsule are no longer round, but here they are hidden in the balls.
      Written by test/examples/Helix.java.
      """)
      .raster(640, 900, "16 22 40", true)
      .camera("0 0 40", "0 0 0", "0.55 1 0")
      .projection("perspective", "fov", "32", "aspect", "0.711111")
      .model("ball", "sphere", "radius", "0.46")
      .model("bond", "capsule", "A", "0 -0.5 0", "B", "0 0.5 0", "radius", "0.2");

  private Helix() {
  }

  /** The text of the file. */
  static String text() {
    final Helix helix = new Helix();
    final Random random = new Random(1953);
    for (int i = 0; i < PAIRS; i++) {
      final int base = random.nextInt(BASES.length);
      helix.pair(i, BASES[base], BASES[base ^ 1]);
    }
    return helix.scene.toString();
  }

  private void pair(final int i, final String left, final String right) {
    final double[] a = place(i, 0), b = place(i, GROOVE);
    final double[] middle = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    scene.object("ball", STRAND, "translation", triple(a[0], a[1], a[2]));
    scene.object("ball", STRAND, "translation", triple(b[0], b[1], b[2]));
    bond(a, middle, left);
    bond(middle, b, right);
    if (i > 0) {
      bond(place(i - 1, 0), a, STRAND);
      bond(place(i - 1, GROOVE), b, STRAND);
    }
  }

  private static double[] place(final int i, final double groove) {
    final double angle = i * TURN + groove;
    return new double[] {RADIUS * cos(angle), (i - (PAIRS - 1) / 2.0) * RISE, RADIUS * sin(angle)};
  }

  private void bond(final double[] from, final double[] to, final String colour) {
    final double x = to[0] - from[0], y = to[1] - from[1], z = to[2] - from[2];
    scene.object("bond", colour,
        "scaleFactors", "1 " + Numbers.text(Math.sqrt(x * x + y * y + z * z), 3) + " 1",
        "jVector", triple(x, y, z), "iauxVector", Math.abs(x) < Math.abs(z) ? "1 0 0" : "0 0 1",
        "translation", triple((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2));
  }
}
