package examples;

import static examples.Numbers.cos;
import static examples.Numbers.sin;
import static examples.Numbers.triple;

import java.util.Map;

/** A round temple, seen through each of the three projections, and in the evening. */
final class Temple {

  private static final int COLUMNS = 14;
  private static final double RING = 6;
  private static final String STONE = "244 232 208";
  private static final String BRONZE = "205 130 70";
  private static final String[] BALLS = {"226 90 74", "244 180 70", "84 160 150", "70 110 180"};

  private static final String ISLAND = "176 206 120";
  private static final String[] STEPS = {"214 200 176", "226 213 190", "236 224 202"};

  /** The materials by lamplight, by the colours of daylight. */
  private static final Map<String, String> MATERIALS = Map.of(STONE, "stone", BRONZE, "bronze", ISLAND, "grass",
      STEPS[0], "step", STEPS[1], "step", STEPS[2], "step", BALLS[0], "red glaze", BALLS[1], "yellow glaze",
      BALLS[2], "green glaze", BALLS[3], "blue glaze");

  private final SceneText scene;
  private final boolean lit;

  private Temple(final String name, final String comment) {
    lit = false;
    scene = new SceneText(name, comment + """
        The scene is that of orthographic.xml, perspective.xml and angular.xml; only camera and projection differ.
        Written by test/examples/Temple.java.
        """);
  }

  private Temple(final SceneText scene) {
    lit = true;
    this.scene = scene;
  }

  /** The temple under lamps. */
  static String evening() {
    final String conductive = "conductiveReflectance", diffuse = "diffuseReflectance";
    final SceneText scene = new SceneText("temple in the evening", """
        The temple of perspective.xml after sunset. A lamp hangs in its middle and throws the shadows of the columns out over
        the island; the last light of the sun comes from the left, a beam of parallel rays (directional); the sky brightens
        what both leave dark, as a weak lamp high up: there is no other light from everywhere.
        Written by test/examples/Temple.java.
        """)
        .litRaster(900, 720, "30 36 70", 3)
        .camera("3.1 6.8 13.6", "0 2.1 0", "0 1 0")
        .projection("perspective", "fov", "54", "aspect", "1.25")
        .light("omnidirectional", "spectrum", "0.44 0.335 0.225", "power", "230", "position", "0 4.4 0")
        .light("directional", "spectrum", "0.56 0.29 0.15", "power", "190", "position", "-30 9 6", "lookAt", "0 2.5 0",
            "radius", "16")
        .light("omnidirectional", "spectrum", "0.26 0.33 0.41", "power", "900", "position", "9 30 24")
        .brdf("stone", "Oren-Nayar", diffuse, "0.66 0.6 0.5", "sigma", "20")
        .brdf("step", "Oren-Nayar", diffuse, "0.56 0.5 0.41", "sigma", "20")
        .brdf("grass", "Oren-Nayar", diffuse, "0.2 0.32 0.1", "sigma", "40")
        .brdf("bronze", "Cook-Torrance", diffuse, "0.1 0.05 0.02", conductive, "0.75 0.45 0.22", "ndf", "Beckmann",
            "beta", "16");
    glaze(scene, "red glaze", "0.6 0.08 0.06");
    glaze(scene, "yellow glaze", "0.68 0.42 0.06");
    glaze(scene, "green glaze", "0.07 0.34 0.28");
    glaze(scene, "blue glaze", "0.06 0.14 0.45");
    return new Temple(scene).built();
  }

  private static void glaze(final SceneText scene, final String id, final String diffuse) {
    scene.brdf(id, "Ashikhmin-Shirley", "diffuseReflectance", diffuse, "conductiveReflectance", "0.06 0.06 0.06",
        "beta", "0");
  }

  private String look(final String colour) {
    return lit ? MATERIALS.get(colour) : colour;
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
    if (!lit) {
      scene.model("sky", "sphere", "radius", "60");
    }
    scene.model("island", "cylinder", "radius", "10.5", "Axislength", "0.8")
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
    if (!lit) {
      scene.comment("The camera is inside the sky, which is a shape like any other.").object("sky", "186 214 236");
    }
    scene.object("island", look(ISLAND), "translation", "0 -1.6 0")
        .object("lowest step", look(STEPS[0]), "translation", "0 -1 0")
        .object("middle step", look(STEPS[1]), "translation", "0 -0.6 0")
        .object("upper step", look(STEPS[2]), "translation", "0 -0.2 0")
        .object("plinth", look(STONE), "translation", "0 0.5 0")
        .object("egg", look(BRONZE), "translation", "0 2.1 0")
        .object("architrave", look(STONE), "translation", "0 5.35 0", "scaleFactors", "1 0.8 1");
    for (int i = 0; i < COLUMNS; i++) {
      column(360.0 * (i + 0.5) / COLUMNS, BALLS[i % BALLS.length]);
    }
    return scene.toString();
  }

  /** A column, and a ball on top of it. */
  private void column(final double degrees, final String ball) {
    final double x = RING * cos(degrees), z = RING * sin(degrees);
    scene.object("base", look(STONE), "translation", triple(x, 0.16, z))
        .object("shaft", look(STONE), "translation", triple(x, 2.3, z))
        .object("capital", look(STONE), "rotationAngle", Numbers.text(-degrees, 3), "translation", triple(x, 4.75, z))
        .object("ball", look(ball), "translation", triple(x, 6.1, z));
  }
}
