package examples;

import static examples.Numbers.cos;
import static examples.Numbers.sin;
import static examples.Numbers.triple;

/** The inside of a torus, with rings along its wall and balls along its middle. */
final class Tunnel {

  private static final double R = 12;
  private static final double BALL_STEP = 5;
  private static final int[][] COLOURS = {{255, 90, 95}, {255, 180, 80}, {250, 230, 120}, {90, 220, 180}, {80, 150, 255},
      {170, 100, 240}, {255, 90, 95}};

  private Tunnel() {
  }

  /** The text of the file. */
  static String scene() {
    final SceneText scene = new SceneText("tunnel", """
        Inside a torus. A ray that starts inside a closed shape hits its far wall, so a camera may stand anywhere.
        The hoops are tori too. A torus turns about its Y axis; jVector lays this axis along the tunnel.
        Written by test/examples/Tunnel.java.
        """)
        .raster(900, 600, "0 0 0", true)
        .camera("12 0.5 0", "8.9 -0.35 8.05", "0 1 0")
        .projection("perspective", "fov", "80", "aspect", "1.5")
        .model("tunnel", "torus", "rotationalRadius", "12", "circunferenceRadius", "3")
        .model("hoop", "torus", "rotationalRadius", "2.9", "circunferenceRadius", "0.12")
        .model("ball", "sphere", "radius", "0.32")
        .object("tunnel", "120 150 215");
    for (int degrees = 0; degrees < 360; degrees += 10) {
      scene.object("hoop", "255 240 214", "jVector", triple(-sin(degrees), 0, cos(degrees)), "iauxVector", "0 1 0",
          "translation", triple(R * cos(degrees), 0, R * sin(degrees)));
    }
    for (double degrees = 20; degrees < 170; degrees += BALL_STEP) {
      final double wind = 40 * degrees / BALL_STEP, out = R + 1.5 * cos(wind);
      scene.object("ball", SceneText.scale(degrees % 60 / 60, COLOURS),
          "translation", triple(out * cos(degrees), 1.5 * sin(wind), out * sin(degrees)));
    }
    return scene.toString();
  }
}
