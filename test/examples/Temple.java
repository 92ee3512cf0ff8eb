package examples;

import static examples.Numbers.cos;
import static examples.Numbers.sin;
import static examples.Numbers.triple;

/** A round temple, seen through each of the three projections. */
final class Temple {

  private static final int COLUMNS = 14;
  private static final double RING = 6;
  private static final String STONE = "244 232 208";
  private static final String BRONZE = "205 130 70";
  private static final String[] BALLS = {"226 90 74", "244 180 70", "84 160 150", "70 110 180"};

  private final SceneText scene;

  private Temple(final String name, final String comment) {
    scene = new SceneText(name, comment + """
        The scene is that of orthographic.xml, perspective.xml and angular.xml; only camera and projection differ.
        Written by test/examples/Temple.java.
        """);
  }

  /** Parallel rays. */
  static String orthographic() {
    final Temple temple = new Temple("temple, orthographic", """
        Parallel rays: things keep their size, however far away, and parallel edges stay parallel, as in a plan.
        height is that of the window in scene units; aspect is its width by its height, best W by H of the raster.
        """);
    temple.scene.raster(900, 720, "20 22 30", true)
        .camera("17.6 22 22.1", "0 1.5 0", "0 1 0")
        .projection("orthographic", "height", "18.4", "aspect", "1.25");
    return temple.built();
  }

  /** Rays from the eye, through a window. */
  static String perspective() {
    final Temple temple = new Temple("temple, perspective", """
        Rays from one point, as in the eye: what is far is small.
        fov is the angle of view from the lower to the upper edge, in degrees; aspect is the width of the window by its
        height, best W by H of the raster.
        """);
    temple.scene.raster(900, 720, "20 22 30", true)
        .camera("3.1 6.8 13.6", "0 2.1 0", "0 1 0")
        .projection("perspective", "fov", "54", "aspect", "1.25");
    return temple.built();
  }

  /** Rays from the eye, through a dome. */
  static String angular() {
    final Temple temple = new Temple("temple, angular", """
        A fish-eye: half of all that can be seen, in a circle. The camera hangs over the temple and looks down.
        fov is the angle of view across the circle, in degrees, up to 180; outside the circle there are no rays.
        """);
    temple.scene.raster(800, 800, "20 22 30", true)
        .camera("0 8 1.2", "0 0 0.3", "0 0 -1")
        .projection("angular", "fov", "180");
    return temple.built();
  }

  private String built() {
    scene.model("sky", "sphere", "radius", "60")
        .model("island", "cylinder", "radius", "10.5", "Axislength", "0.8")
        .model("lowest step", "cylinder", "radius", "8.4", "Axislength", "0.4")
        .model("middle step", "cylinder", "radius", "7.7", "Axislength", "0.4")
        .model("upper step", "cylinder", "radius", "7", "Axislength", "0.4")
        .model("base", "torus", "rotationalRadius", "0.42", "circunferenceRadius", "0.16")
        .model("shaft", "cylinder", "radius", "0.42", "Axislength", "4.6")
        .model("capital", "box", "width", "1.15", "height", "0.3", "depth", "1.15")
        .model("architrave", "torus", "rotationalRadius", "6", "circunferenceRadius", "0.5")
        .model("plinth", "cylinder", "radius", "1.1", "Axislength", "1")
        .model("egg", "ellipsoid", "a", "0.8", "b", "1.15", "c", "0.8")
        .model("ball", "sphere", "radius", "0.42");
    scene.comment("The camera is inside the sky, which is a shape like any other.")
        .object("sky", "186 214 236")
        .object("island", "176 206 120", "translation", "0 -1.6 0")
        .object("lowest step", "214 200 176", "translation", "0 -1 0")
        .object("middle step", "226 213 190", "translation", "0 -0.6 0")
        .object("upper step", "236 224 202", "translation", "0 -0.2 0")
        .object("plinth", STONE, "translation", "0 0.5 0")
        .object("egg", BRONZE, "translation", "0 2.1 0")
        .object("architrave", STONE, "translation", "0 5.35 0", "scaleFactors", "1 0.8 1");
    for (int i = 0; i < COLUMNS; i++) {
      column(360.0 * (i + 0.5) / COLUMNS, BALLS[i % BALLS.length]);
    }
    return scene.toString();
  }

  /** A column, and a ball on top of it. */
  private void column(final double degrees, final String ball) {
    final double x = RING * cos(degrees), z = RING * sin(degrees);
    scene.object("base", STONE, "translation", triple(x, 0.16, z))
        .object("shaft", STONE, "translation", triple(x, 2.3, z))
        .object("capital", STONE, "rotationAngle", Numbers.text(-degrees, 3), "translation", triple(x, 4.75, z))
        .object("ball", ball, "translation", triple(x, 6.1, z));
  }
}
