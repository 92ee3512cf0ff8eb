package scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.nio.file.Path;
import java.util.List;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

/** The quirks of the scene language, by their numbers: Q1 to Q22. */
class QuirksTest {

  private static final String LIT = "<illumination>true</illumination>";
  private static final String UNLIT = "<illumination>false</illumination>";
  private static final String LIGHT = "<lights><light type=\"omnidirectional\"><position>0 9 0</position>"
      + "<spectrum>0.33 0.34 0.33</spectrum><power>100</power></light></lights>";
  private static final String MATERIAL = "<materials><brdf id=\"m\" type=\"Phong-Lafortune\"><diffuseReflectance>0.4 0 0.2"
      + "</diffuseReflectance><conductiveReflectance>0.6 0 0.2</conductiveReflectance></brdf></materials>";
  private static final String NO_EFFECT = "warning: lights and materials have no effect without illumination";

  private static final String POLISHED = "30:14: warning: `beta` is not given: this `brdf` is polished and reflects like a "
      + "mirror";

  @TempDir
  Path folder;

  private SceneFiles files;

  @BeforeEach
  void start() {
    files = new SceneFiles(folder);
  }

  private static void assertProblems(final ReadResult reading, final String... lines) {
    assertEquals(List.of(lines), SceneFiles.lines(reading));
  }

  private static Color colour(final ReadResult reading) {
    final Ray ray = new Ray(new Point3D(0, 0, 5), new Vector3D(0, 0, -1));
    return reading.scene().orElseThrow().objects().intersectionWith(ray).getObject().getColor();
  }

  @Test
  void q1CameraWithinAComment() {
    final String text = SceneFiles.SOUND.replace("<camera>", "<!--<camera>").replace("</camera>", "</camera>-->");
    assertProblems(files.read(text), "2:1: `image` lacks `camera`: expected an element <camera>."
        + " Line 16 has a `camera` that is commented out.");
    assertProblems(files.readWith("<fov>60</fov>", "<!-- <fovea/> <fov> 60</fov>-->"), "21:3: `projection` lacks "
        + "`fov`: expected a "
        + "number such as 2.5, 0 < fov < 180.");
    assertProblems(files.readWith("<fov>60</fov>", "<!-- <fov> 60</fov>-->"), "21:3: `projection` lacks `fov`: expected a "
        + "number such as 2.5, 0 < fov < 180. Line 22 has a `fov` that is commented out.");
  }

  @Test
  void q2StrayText() {
    assertProblems(files.readWith("</model>", "</model>\n-->"), "29:1: warning: `-->` between the elements of `models` is "
        + "ignored; perhaps it is left over from a comment");
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
    "<W>40</W>|3:3|raster|W|a whole number, W >= 1",
    "<backgroundColor>0.2 0.4 0.6</backgroundColor>|3:3|raster|backgroundColor|a colour: three numbers from 0 to 1, "
        + "or from 0 to 255",
    "<showProgress>true</showProgress>|8:3|rayTracer|showProgress|`true` or `false`",
    "<illumination>false</illumination>|13:3|engine|illumination|`true` or `false`",
    "<lookAt>0 0 0</lookAt>|16:3|camera|lookAt|three numbers separated by blanks, such as 1 0.5 2",
    "<fov>60</fov>|21:3|projection|fov|a number such as 2.5, 0 < fov < 180",
    "<radius>1</radius>|26:5|model|radius|a number such as 2.5, radius > 0",
    "<modelId>ball</modelId>|31:5|object|modelId|a name"})
  void q3MissingValues(final String value, final String place, final String element, final String name,
      final String expected) {
    assertProblems(files.readWith(value, ""), place + ": `" + element + "` lacks `" + name + "`: expected " + expected
        + ".");
  }

  @Test
  void q3IdsThatNameNothing() {
    assertProblems(files.readWith("<modelId>ball", "<modelId>Bull"),
        "32:16: `modelId` names nothing: found `Bull`, expected an id of this file. Did you mean `ball`?");
    assertProblems(files.readWith("type=\"perspective\"", ""), "21:3: `projection` lacks the attribute `type`: "
        + "expected type=\"...\"");
    assertProblems(files.readWith("id=\"ball\"", ""), "26:5: `model` lacks the attribute `id`: expected id=\"...\"",
        "32:16: `modelId` names nothing: found `ball`, expected an id of this file.");
  }

  @Test
  void q4SeveralBlocksOfModels() {
    final String second = "</models><models><model id=\"second\" type=\"sphere\"><radius>2</radius></model></models>";
    final String text = SceneFiles.with("</models>", second).replace("<modelId>ball", "<modelId>second");
    assertProblems(files.read(text));
  }

  @Test
  void q5AppearanceAgainstEngine() {
    final String material = SceneFiles.with("<scene>", MATERIAL + "<scene>").replace("<color>255 0 0</color>",
        "<materialId>m</materialId>");
    final ReadResult fallback = files.read(material);
    assertProblems(fallback, "30:3: " + NO_EFFECT, "33:19: warning: a material has no effect without illumination: "
        + "the object shows "
        + "the sum of its reflectances; expected a `color`");
    assertEquals(new Color(255, 0, 102), colour(fallback));
    final ReadResult lit = files.read(material.replace(UNLIT, LIT).replace("<scene>", LIGHT + "<scene>"));
    assertTrue(lit.scene().orElseThrow().isLit());
    assertEquals(new Color(255, 0, 102), colour(lit));
    assertProblems(lit, POLISHED);
    assertProblems(files.read(material.replace(UNLIT, LIT)), "14:19: there is no light: with illumination expected an "
        + "element <light> in <lights>", POLISHED);
    assertProblems(files.readWith(UNLIT, LIT + LIGHT), "14:38: warning: `lights` is out of place in `engine`: it "
        + "belongs in `image`", "33:7: warning: `color` without a `materialId`: with illumination the object is matte, of "
        + "this colour");
    assertProblems(files.readWith("<color>255 0 0</color>", ""), "31:5: the object has no appearance: expected a `color`");
    assertProblems(files.read(SceneFiles.with("<color>255 0 0</color>", "").replace(UNLIT, LIT).replace("<scene>",
        LIGHT + "<scene>")), "31:5: the object has no `materialId`: with illumination expected one");
  }

  @Test
  void q5AColourCountsBeforeAMaterialWithoutIllumination() {
    final ReadResult reading = files.read(SceneFiles.with("<scene>", MATERIAL + "<scene>").replace("<color>255 0 0</color>",
        "<color>0 255 0</color><materialId>m</materialId>"));
    assertProblems(reading, "30:3: " + NO_EFFECT);
    assertEquals(Color.GREEN, colour(reading));
  }

  @Test
  void q6Aspect() {
    assertProblems(files.readWith("    <aspect>1.3333</aspect>\n", ""), "21:3: warning: `aspect` is not given and "
        + "counts as 1.0, but "
        + "the raster of 40 x 30 pixels has 1.333: the picture will be stretched");
    assertProblems(files.readWith("<aspect>1.3333</aspect>", "<aspect>2</aspect>"), "23:13: warning: `aspect` is 2.0 "
        + "but the raster of "
        + "40 x 30 pixels has 1.333: the picture will be stretched");
    assertProblems(files.readWith("<aspect>1.3333</aspect>", "<aspect>-1</aspect>"),
        "23:13: `aspect` is out of range: found `-1`, expected a number such as 2.5, aspect > 0");
  }

  @Test
  void q6TheWindowOfTheFishEyeIsSquare() {
    final String angular = "<projection type=\"angular\">\n    <fov>90</fov>";
    final String perspective = "<projection type=\"perspective\">\n    <fov>60</fov>\n    <aspect>1.3333</aspect>";
    assertProblems(files.readWith(perspective, angular), "21:3: warning: the window of an angular projection is square, but "
        + "the raster has 40 x 30 pixels: the picture will be stretched");
    assertProblems(files.read(SceneFiles.with(perspective, angular).replace("<W>40", "<W>30")));
  }

  @Test
  void q7AimingTakesTheAxesOfTheModelAlongTheVectors() {
    final ReadResult box = files.read(SceneFiles.with("type=\"sphere\"", "type=\"box\"").replace("<radius>1</radius>",
        "<width>4</width><height>1</height><depth>1</depth>").replace("</color>",
        "</color><iVector>1 0 -1</iVector><jauxVector>0 1 0</jauxVector>"));
    assertProblems(box);
    final Ray ray = new Ray(new Point3D(5, 0, -5), new Vector3D(-1, 0, 1));
    assertEquals(Math.sqrt(50) - 2, box.scene().orElseThrow().objects().intersectionWith(ray).getT(), 1e-5);
  }

  @Test
  void q8FourthNumber() {
    final ReadResult reading = files.readPlaced("<translation>0.0 0 1 .0</translation>");
    assertProblems(reading, "34:22: warning: `translation` has more than three numbers: `.0` and what follows is ignored");
    final Ray ray = new Ray(new Point3D(0, 0, 5), new Vector3D(0, 0, -1));
    assertEquals(3, reading.scene().orElseThrow().objects().intersectionWith(ray).getT(), 1e-6);
    assertProblems(files.readPlaced("<translation>1 2</translation>"), "34:14: `translation` has 2 of three numbers: "
        + "found `1 2`, expected three "
        + "numbers separated by blanks, such as 1 0.5 2");
    assertProblems(files.readPlaced("<translation>1,2,3</translation>"), "34:14: `translation` has 1 of three "
        + "numbers: found `1,2,3`, expected "
        + "three numbers separated by blanks, such as 1 0.5 2");
  }

  @Test
  void q9MissingMesh() {
    assertProblems(files.readModel("mesh", "<objFile>no/such.obj</objFile>"), "27:16: there is no mesh file "
        + "`no/such.obj`: looked for "
        + folder.resolve("no/such.obj") + ", " + Path.of("scenes", "no", "such.obj"));
    files.write("folder.obj/x", "");
    assertProblems(files.readModel("mesh", "<objFile>folder.obj</objFile>"), "27:16: there is no mesh file "
        + "`folder.obj`: looked for "
        + folder.resolve("folder.obj") + " (a folder), " + Path.of("scenes", "folder.obj"));
  }

  @Test
  void q10MissingTexture() {
    assertProblems(files.readPlaced("<textureFile>no.png</textureFile>"), "34:14: there is no texture file `no.png`: "
        + "looked for "
        + folder.resolve("no.png") + ", " + Path.of("scenes", "no.png"));
    files.write("wood.png", "");
    assertProblems(files.readPlaced("<textureFile>wood.png</textureFile>"), "34:14: the texture file `wood.png` cannot be "
        + "used: not a PNG, JPEG, GIF or BMP image, as its content shows");
  }

  @ParameterizedTest
  @CsvSource({"200 125 200, 200, 125, 200, false", "0.3 0.3 0.3, 77, 77, 77, false", "1 1 1, 255, 255, 255, false",
    "255 1 0, 255, 1, 0, true", "2 0 0, 2, 0, 0, false", "1.001 0 0, 1, 0, 0, false", "200 125 0.5, 200, 125, 1, true",
    "0.5 0.002 0, 128, 1, 0, false", "127.5 0 254.49, 128, 0, 254, false"})
  void q11Colours(final String text, final int red, final int green, final int blue, final boolean mixed) {
    final ReadResult reading = files.readWith("255 0 0", text);
    assertEquals(new Color(red, green, blue), colour(reading));
    assertEquals(mixed, reading.problems().size() == 1);
    if (mixed) {
      assertProblems(reading, "33:14: warning: `color` mixes the ranges 0-1 and 0-255: `" + text + "` is taken as 0-255");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"256 0 0", "-1 0 0", "NaN 0 0"})
  void q11WrongColours(final String text) {
    assertEquals(1, files.readWith("255 0 0", text).problems().size());
  }

  @Test
  void q12Booleans() {
    assertProblems(files.readWith("<showProgress>true", "<showProgress> False "));
    assertProblems(files.readWith("<showProgress>true", "<showProgress>yes"),
        "11:19: `showProgress` is neither true nor false: found `yes`, expected `true` or `false`");
    assertProblems(files.readWith("<illumination>false", "<illumination>1"),
        "14:19: `illumination` is neither true nor false: found `1`, expected `true` or `false`");
  }

  @Test
  void q13BlanksAboutValues() {
    final String text = SceneFiles.with("<W>40", "<W> 40 ").replace("<modelId>ball", "<modelId>\n ball\n")
        .replace("<radius>1", "<radius> 1\t").replace("id=\"ball\"", "id=\" ball \"");
    assertProblems(files.read(text));
  }

  @ParameterizedTest
  @ValueSource(strings = {"40.0", "4e1", "", "1 2", "0x28", "40f", "99999999999", "-3"})
  void q13WrongIntegers(final String text) {
    assertEquals(1, files.readWith("<W>40", "<W>" + text).problems().size());
  }

  @ParameterizedTest
  @ValueSource(strings = {"0.5f", "1d", "0x1p0", "NaN", "Infinity", "1,5", "1e", "e1", ".", "+-1", "1e99", "--1", "1.2.3"})
  void numbersAreDecimal(final String text) {
    final ReadResult reading = files.readWith("<radius>1", "<radius>" + text);
    assertEquals(1, reading.problems().size());
    assertTrue(reading.problems().get(0).message().contains("found `" + text + "`"), reading.problems().toString());
  }

  @Test
  void aValueWithoutTextIsEmpty() {
    for (final String[] value : new String[][] {{"<radius>1", "radius"}, {"<W>40", "W"},
        {"<illumination>false", "illumination"}}) {
      final String message = files.readWith(value[0], "<" + value[1] + "> ").problems().get(0).message();
      assertTrue(message.startsWith("`" + value[1] + "` is empty: expected "), message);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"5", "+5.0", ".5", "1e-3", "5.", "1E+2", "00.10"})
  void allFormsOfDecimals(final String text) {
    assertProblems(files.readWith("<radius>1", "<radius>" + text));
  }

  @Test
  void q14UnknownTypes() {
    assertProblems(files.readWith("\"perspective\"", "\"Perspective\""), "21:15: `projection` of an unknown type: found "
        + "`Perspective`, expected one of "
        + "perspective, orthographic, angular, nlperspective. Did you mean `perspective`?");
    assertProblems(files.readWith("\"perspective\"", "\"nlperspective\""), "21:15: projection not supported: found "
        + "`nlperspective`, "
        + "expected perspective, orthographic or angular",
        "23:5: warning: `aspect` has no effect in `projection` of type `nlperspective`");
    assertProblems(files.readWith("\"sphere\"", "\"cyclide\""), "26:22: `model` of an unknown type: found `cyclide`, "
        + "expected one of sphere, box, plane, cylinder, capsule, truncone, torus, ellipsoid, egg, genus2, mesh.");
    assertProblems(files.readWith("<scene>", LIGHT.replace("omnidirectional", "omnidirectinal") + "<scene>"), "30:3: "
        + NO_EFFECT,
        "30:18: `light` of an unknown type: found `omnidirectinal`, expected one of omnidirectional, directional, spot. "
            + "Did you mean "
            + "`omnidirectional`?");
    assertProblems(files.readWith("<scene>", MATERIAL.replace("Phong-Lafortune", "Ward") + "<scene>"), "30:3: " + NO_EFFECT,
        "30:27: `brdf` of an unknown type: found `Ward`, expected one of Phong-Lafortune, Phong, "
            + "Ashikhmin-Shirley, Cook-Torrance, "
            + "Oren-Nayar, "
            + "Ideal-Conductor.");
    assertProblems(files.readWith("<scene>", MATERIAL.replace("</brdf>", "<ndf>Blin</ndf></brdf>")
        + "<scene>"), "30:3: " + NO_EFFECT,
        "30:161: `ndf` of an unknown type: found `Blin`, expected one of Blinn, Horn, Torrance, GGX, Beckmann. "
            + "Did you mean `Blinn`?");
    assertProblems(files.readWith("<scene>", "<materials><btdf id=\"g\" "
        + "type=\"Glass\"><eta_int>1.5</eta_int></btdf></materials><scene>"),
        "30:3: " + NO_EFFECT, "30:27: `btdf` of an unknown type: found `Glass`, expected one of Ideal-Dielectric, "
            + "Cook-Torrance.");
  }

  @Test
  void q15UnknownElements() {
    assertProblems(files.readModel("cylinder", "<radius>1</radius><axisLength>2</axisLength>"),
        "26:5: `model` lacks `Axislength`: expected a number such as 2.5, Axislength > 0.",
        "27:25: warning: unknown element `axisLength` in `model`. Did you mean `Axislength`?");
    assertProblems(files.readWith("</object>", "<colour>1 1 1</colour></object>"),
        "34:5: warning: unknown element `colour` in `object`. Did you mean `color`?");
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
    "<radius>1|<radius>0", "<radius>1|<radius>-1", "<W>40|<W>0", "<lookAt>0 0 0|<lookAt>0 0 5", "<up>0 1 0|<up>0 0 2",
    "<up>0 1 0|<up>0 0 0", "<up>0 1 0|<up>0 1e-9 1", "<fov>60|<fov>0", "<fov>60|<fov>180", "<aspect>1.3333|<aspect>0",
    "</color>|</color><scaleFactors>1 0 "
        + "1</scaleFactors>", "</color>|</color><rotationAngle>9</rotationAngle><rotationAxis>0 0 0"
    + "</rotationAxis>", "</color>|</color><iVector>0 0 0</iVector><jauxVector>0 1 0</jauxVector>",
    "</color>|</color><iVector>1 2 3</iVector><kauxVector>2 4 6</kauxVector>", "</color>|</color><jVector>1 2 3</jVector>",
    "</illumination>|</illumination><recursionDepth>-1</recursionDepth>"})
  void q16ValuesThatDescribeNothing(final String part, final String other) {
    final ReadResult reading = files.readWith(part, other);
    assertEquals(1, reading.problems().size(), reading.problems().toString());
    assertTrue(reading.problems().get(0).isError());
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
    "box|<width>0</width><height>1</height><depth>1</depth>", "plane|<point>0 0 0</point><normal>0 0 0</normal>",
    "cylinder|<radius>1</radius><Axislength>0</Axislength>", "capsule|<A>0 0 0</A><B>0 1 0</B><radius>0</radius>",
    "torus|<rotationalRadius>-1</rotationalRadius><circunferenceRadius>1</circunferenceRadius>",
    "ellipsoid|<a>1</a><b>0</b><c>1</c>"})
  void q16ModelsThatDescribeNothing(final String type, final String values) {
    final ReadResult reading = files.readModel(type, values);
    assertEquals(1, reading.problems().size(), reading.problems().toString());
    assertTrue(reading.problems().get(0).isError());
  }

  @Test
  void q16BlocksOfNoSizeCountAsOne() {
    assertProblems(files.readWith("<wblock>32", "<wblock>0"), "9:13: warning: `wblock` is 0: taken as 1");
    assertProblems(files.readWith("<wblock>32", "<wblock>3200"));
    assertProblems(files.readWith("<wblock>32", "<wblock>x"), "9:13: `wblock` is not a whole number: found `x`, "
        + "expected a whole number");
  }

  @Test
  void q17TheSpellingOfTheDictionary() {
    assertProblems(files.readModel("torus",
        "<rotationalRadius>2</rotationalRadius><circumferenceRadius>1</circumferenceRadius>"),
        "27:45: warning: `circumferenceRadius` is spelt `circunferenceRadius` in scene files; read as "
            + "`circunferenceRadius`");
  }

  @Test
  void q18SpectrumSumsToOneWithTolerance() {
    assertProblems(files.readWith("<scene>", LIGHT.replace("0.33 0.34 0.33", "0.33333 0.33333 0.33333")
        + "<scene>"), "30:3: " + NO_EFFECT);
    assertProblems(files.readWith("<scene>", LIGHT.replace("0.33 0.34 0.33", "0.3 0.3 0.3") + "<scene>"), "30:3: "
        + NO_EFFECT,
        "30:77: the shares of `spectrum` must sum to 1: found `0.3 0.3 0.3`, expected for example 0.33 0.34 0.33");
  }

  @Test
  void q19NamesWithoutEffect() {
    final String light = LIGHT.replace("omnidirectional", "directional").replace("</light>",
        "<lookAt>0 0 0</lookAt><radius>5</radius>\n<attenuationExponent>0</attenuationExponent></light>");
    assertProblems(files.readWith("<scene>", light + "<scene>"), "30:3: " + NO_EFFECT,
        "31:1: warning: `attenuationExponent` is a name of another edition and is ignored");
    assertProblems(files.readWith("<scene>", MATERIAL.replace("</brdf>", "<alpha>2</alpha></brdf>")
        + "<scene>"), "30:3: " + NO_EFFECT);
  }

  @Test
  void q20MeshesBesideTheScene() {
    files.write("deep/er/one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assertProblems(files.readModel("mesh", "<objFile>deep/er/one.obj</objFile><flat>true</flat>"));
    assertProblems(files.readModel("mesh", "<objFile> deep/../deep/er/one.obj\n</objFile>"));
    assertProblems(files.readModel("mesh", "<objFile>deep\\er\\one.obj</objFile>"),
        "27:16: warning: `deep\\er\\one.obj` contains backslashes: taken for `/`, which works on every system");
  }

  @Test
  void q21TheFishEyeHasNoRayOutsideItsCircle() {
    for (final int fov : new int[] {90, 180}) {
      final SceneFile scene =
          files.readWith("<projection type=\"perspective\">\n    <fov>60</fov>\n    <aspect>1.3333</aspect>",
          "<projection type=\"angular\">\n    <fov>" + fov + "</fov>").scene().orElseThrow();
      assertSame(Ray.NORAY, scene.camera().getRayGenerator(100, 100).getRay(0, 0));
      assertSame(Ray.NORAY, scene.camera().getRayGenerator(100, 100).getRay(99, 90));
    }
    assertProblems(files.readWith("<projection type=\"perspective\">\n    <fov>60</fov>\n    <aspect>1.3333</aspect>",
        "<projection type=\"angular\">\n    <fov>181</fov>"),
        "22:10: `fov` is out of range: found `181`, expected a number such as 2.5, 0 < fov <= 180");
  }

  @Test
  void q22AllProblemsInOneRun() {
    final String text = SceneFiles.SOUND.replace("<W>40</W>", "").replace("60", "x").replace("<radius>1</radius>", "");
    assertEquals(3, files.read(text).problems().size());
  }
}
