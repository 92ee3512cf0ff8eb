package scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import lights.Light;
import lights.LightGroup;
import materials.Material;
import models.Object3D;
import primitives.Point3D;
import radiometry.RadianceRGB;

/** Lights, materials and the engine of lit scene files. */
class LightingTest {

  private static final String LIGHT = "<light type=\"omnidirectional\"><spectrum>0.5 0.25 0.25</spectrum><power>100</power>"
      + "<position>0 2 0</position></light>";
  private static final String BRDF = "<brdf id=\"m\" type=\"Phong\"><diffuseReflectance>0.5 0.4 0.3</diffuseReflectance>"
      + "</brdf>";

  @TempDir
  Path folder;

  private SceneFiles files;

  @BeforeEach
  void start() {
    files = new SceneFiles(folder);
  }

  /** A lit scene: the contents of its engine besides illumination, its lights in line 30, its materials in line 31. */
  private ReadResult read(final String engine, final String lights, final String materials, final String look) {
    return files.read(SceneFiles.with("<illumination>false</illumination>", "<illumination>true</illumination>" + engine)
        .replace("<scene>", "<lights>" + lights + "</lights>\n<materials>" + materials + "</materials><scene>")
        .replace("<color>255 0 0</color>", look));
  }

  private ReadResult withMaterial(final String material) {
    return read("", LIGHT, material, "<materialId>m</materialId>");
  }

  private static void assertProblems(final ReadResult reading, final String... lines) {
    assertEquals(List.of(lines), SceneFiles.lines(reading));
  }

  private static Material material(final ReadResult reading) {
    return reading.scene().orElseThrow().objects().getObjects().get(0).getMaterial();
  }

  @Test
  void aLitSceneHasLightsDepthAndExposure() {
    final ReadResult reading = read("<recursionDepth>7</recursionDepth><exposure>-1.5</exposure>", LIGHT, BRDF,
        "<materialId>m</materialId>");
    assertProblems(reading);
    final SceneFile scene = reading.scene().orElseThrow();
    assertTrue(scene.isLit());
    assertEquals(7, scene.recursionDepth());
    assertEquals(-1.5, scene.exposure());
    final Light light = scene.lights().getLights().get(0);
    assertEquals(new Point3D(0, 2, 0), light.getPosition());
    final RadianceRGB power = light.getPower();
    assertEquals(150, power.getR(), 1e-4);
    assertEquals(75, power.getG(), 1e-4);
    scene.lights().addLight(light);
    assertEquals(1, scene.lights().getLights().size(), "the scene's own lights cannot be changed from outside");
  }

  @Test
  void whatAnUnlitSceneDoesNotSayCountsAsNothing() {
    final SceneFile scene = files.read(SceneFiles.SOUND).scene().orElseThrow();
    assertFalse(scene.isLit());
    assertEquals(0, scene.recursionDepth());
    assertEquals(0, scene.exposure());
    assertTrue(scene.lights().getLights().isEmpty());
    assertNull(scene.objects().getObjects().get(0).getMaterial());
  }

  @ParameterizedTest
  @CsvSource({"omnidirectional, Omnidirectional, ''", "directional, Directional, <lookAt>0 0 0</lookAt><radius>3</radius>",
    "spot, Spot, <lookAt>0 0 0</lookAt><aperture>90</aperture>"})
  void eachKindOfLightIsBuilt(final String type, final String name, final String more) {
    final ReadResult reading = read("", LIGHT.replace("omnidirectional", type).replace("</light>", more + "</light>"), BRDF,
        "<materialId>m</materialId>");
    assertProblems(reading);
    final Light light = reading.scene().orElseThrow().lights().getLights().get(0);
    assertEquals(name, light.getClass().getSimpleName());
    assertTrue(light.getIrradianceAt(new Point3D(0.5f, 0, 0)).getR() > 0);
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
    "brdf|Phong-Lafortune|PhongLafortune", "brdf|Phong|PhongLafortune", "brdf|Cook-Torrance|ReflectiveCookTorrance",
    "brdf|Ashikhmin-Shirley|AshikhminShirley", "brdf|Oren-Nayar|OrenNayar", "brdf|Ideal-Conductor|IdealConductor",
    "btdf|Ideal-Dielectric|IdealDielectric", "btdf|Cook-Torrance|TransmissiveCookTorrance"})
  void eachKindOfMaterialIsBuilt(final String element, final String type, final String name) {
    for (final String ndf : new String[] {"Blinn", "Horn", "Torrance", "GGX", "Beckmann"}) {
      final ReadResult reading = withMaterial("<" + element + " id=\"m\" type=\"" + type + "\"><ndf>" + ndf
          + "</ndf><beta>20</beta>" + (element.equals("brdf") ? "<diffuseReflectance>0.5 0.4 0.3</diffuseReflectance>"
              + "<conductiveReflectance>0.2 0.3 0.4</conductiveReflectance><sigma>9</sigma>"
              : "<dielectricReflectance>1 1 0.9</dielectricReflectance><eta_int>1.5</eta_int>") + "</" + element + ">");
      assertProblems(reading);
      assertEquals(name, material(reading).getClass().getSimpleName());
      final String text = material(reading).toString();
      assertEquals(text.contains("beta") || !List.of("OrenNayar", "IdealConductor", "IdealDielectric").contains(name),
          text.contains(ndf), text);
    }
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
    "<spectrum>0.5 0.25 0.25|<spectrum>0.5 0.25 0.2|30:51: the shares of `spectrum` must sum to 1: found `0.5 0.25 0.2`, "
        + "expected for example 0.33 0.34 0.33",
    "<spectrum>0.5|<spectrum>-0.5|30:51: `spectrum` is out of range: found `-0.5`, expected a number such as 0.5, "
        + "0 <= spectrum <= 1",
    "<spectrum>0.5|<spectrum>1.5|30:51: `spectrum` is out of range: found `1.5`, expected a number such as 0.5, "
        + "0 <= spectrum <= 1",
    "<power>100|<power>0|30:82: `power` is out of range: found `0`, expected a number such as 2.5, power > 0",
    "<power>100</power>||30:11: `light` lacks `power`: expected a number such as 2.5, power > 0."})
  void wrongLightsAreErrorsWithTheirPlaces(final String part, final String other, final String message) {
    final List<String> lines = SceneFiles.lines(read("", LIGHT.replace(part, other == null ? "" : other), BRDF,
        "<materialId>m</materialId>"));
    assertEquals(List.of(message), lines);
  }

  @Test
  void aWrongReflectanceIsNotCalledBlackToo() {
    assertProblems(withMaterial(BRDF.replace("0.5 0.4 0.3", "0.5 0.4")), "31:58: `diffuseReflectance` has 2 of three "
        + "numbers: found `0.5 0.4`, expected three numbers separated by blanks, such as 0.2 0.5 0.3, each 0 <= x <= 1");
    assertProblems(withMaterial("<btdf id=\"m\" type=\"Ideal-Dielectric\"><eta_int>1.5</eta_int><dielectricReflectance>2 1 1"
        + "</dielectricReflectance></btdf>"), "31:94: `dielectricReflectance` is out of range: found `2`, "
        + "expected a number such as 0.5, 0 <= dielectricReflectance <= 1");
  }

  @Test
  void examplesInMessagesAreNumbersThatWouldBeRight() {
    assertProblems(withMaterial(BRDF.replace("0.5 0.4 0.3", "1.5 0.4 0.3")), "31:58: `diffuseReflectance` is out of range: "
        + "found `1.5`, expected a number such as 0.5, 0 <= diffuseReflectance <= 1");
    assertProblems(withMaterial("<brdf id=\"m\" type=\"Ideal-Conductor\"></brdf>"), "31:12: `brdf` lacks "
        + "`conductiveReflectance`: expected three numbers separated by blanks, such as 0.2 0.5 0.3, each 0 <= x <= 1.");
    assertProblems(read("", LIGHT.replace("<spectrum>0.5 0.25 0.25</spectrum>", ""), BRDF, "<materialId>m</materialId>"),
        "30:11: `light` lacks `spectrum`: expected three numbers separated by blanks, such as 0.2 0.5 0.3, each "
        + "0 <= x <= 1.");
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
    "<recursionDepth>-1</recursionDepth>|14:54: `recursionDepth` is out of range: found `-1`, expected a whole number, "
        + "recursionDepth >= 0",
    "<exposure>21</exposure>|14:48: `exposure` is out of range: found `21`, expected a number such as 2.5, "
        + "-20 <= exposure <= 20",
    "<exposure>bright</exposure>|14:48: `exposure` is not a number: found `bright`, expected a number such as 2.5, "
        + "-20 <= exposure <= 20"})
  void aWrongEngineIsAnError(final String engine, final String message) {
    assertProblems(read(engine, LIGHT, BRDF, "<materialId>m</materialId>"), message);
  }

  @Test
  void surfacesThatArePerhapsNotMeantSoAreWarnedOf() {
    final String shiny = BRDF.replace("</brdf>", "<conductiveReflectance>0.1 0.1 0.1</conductiveReflectance></brdf>");
    final String polished = "31:12: warning: `beta` is not given: this `brdf` is polished and reflects like a mirror";
    assertProblems(withMaterial(shiny), polished);
    assertProblems(withMaterial(shiny.replace("Phong", "Cook-Torrance")), polished);
    assertProblems(withMaterial(shiny.replace("Phong", "Ashikhmin-Shirley")), polished);
    assertProblems(withMaterial(shiny.replace("Phong", "Oren-Nayar")));
    assertProblems(withMaterial(shiny.replace("</brdf>", "<beta>0</beta></brdf>")));
    assertProblems(withMaterial(BRDF));
    final String glass = "<btdf id=\"m\" type=\"Cook-Torrance\"><eta_int>1.5</eta_int></btdf>";
    final String black = "31:12: warning: this `btdf` transmits nothing and reflects nothing: without a "
        + "`dielectricReflectance` other than 0 it shows black";
    assertProblems(withMaterial(glass), "31:12: warning: `beta` is not given: this `btdf` is polished and shows clear glass",
        black);
    assertProblems(withMaterial(glass.replace("Cook-Torrance", "Ideal-Dielectric")), black);
    assertProblems(withMaterial(glass.replace("<eta_int>1.5</eta_int>", "<beta>5</beta><dielectricReflectance>1 1 1"
        + "</dielectricReflectance>")), "31:12: `btdf` lacks `eta_int`: expected a number such as 2.5, eta_int > 0.");
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
    "Phong|<diffuseReflectance>0.5 0.5 0.5</diffuseReflectance><conductiveReflectance>0.5 0.6 0.5</conductiveReflectance>",
    "Cook-Torrance|<diffuseReflectance>1 0 0</diffuseReflectance><conductiveReflectance>0.1 0 0</conductiveReflectance>",
    "Cook-Torrance|<diffuseReflectance>0 0 0</diffuseReflectance>", "Phong|<sigma>3</sigma>",
    "Ashikhmin-Shirley|<diffuseReflectance>1 1 1</diffuseReflectance>",
    "Ashikhmin-Shirley|<conductiveReflectance>1 1 1</conductiveReflectance>",
    "Oren-Nayar|<conductiveReflectance>1 1 1</conductiveReflectance>",
    "Oren-Nayar|<diffuseReflectance>1 1 1</diffuseReflectance><sigma>90.1</sigma>",
    "Oren-Nayar|<diffuseReflectance>1 1 1</diffuseReflectance><conductiveReflectance>0 0 1.1</conductiveReflectance>",
    "Ideal-Conductor|<diffuseReflectance>1 1 1</diffuseReflectance>",
    "Phong|<diffuseReflectance>1 1 1</diffuseReflectance><beta>-1</beta>"})
  void wrongMaterialsAreErrors(final String type, final String values) {
    final ReadResult reading = withMaterial("<brdf id=\"m\" type=\"" + type + "\"><ndf>GGX</ndf>"
        + (values.contains("beta") ? "" : "<beta>3</beta>") + values + "</brdf>");
    assertEquals(1, reading.problems().size(), reading.problems().toString());
    assertTrue(reading.problems().get(0).isError());
    assertTrue(reading.scene().isEmpty());
  }

  @Test
  void energyMayExceedOneByTheRoundingOfFloats() {
    assertProblems(withMaterial(BRDF.replace("</brdf>", "<conductiveReflectance>0.5 0.6 0.7</conductiveReflectance>"
        + "<beta>3</beta></brdf>")));
  }

  @Test
  void anObjectWithNothingButAColourIsMatte() {
    final ReadResult reading = read("", LIGHT, "", "<color>255 0 0</color>");
    assertProblems(reading, "34:7: warning: `color` without a `materialId`: with illumination the object is matte, of this "
        + "colour");
    final Object3D object = reading.scene().orElseThrow().objects().getObjects().get(0);
    assertNull(object.getMaterial());
    assertEquals(Color.RED, object.getColor());
  }

  @Test
  void theLaterOfTwoMaterialsOfOneIdCountsAndABtdfAfterEachBrdf() {
    final String glass = "<btdf id=\"m\" type=\"Ideal-Dielectric\"><dielectricReflectance>1 1 1</dielectricReflectance>"
        + "<eta_int>1.5</eta_int></btdf>";
    final ReadResult reading = withMaterial(glass + BRDF);
    assertEquals("IdealDielectric", material(reading).getClass().getSimpleName());
    assertEquals(1, reading.problems().size());
  }

  @Test
  void everyShapeTakesAMaterial() {
    final String models = List.of("sphere radius 1", "box width 1 height 1 depth 1", "plane point 0_0_0 normal 0_1_0",
        "cylinder radius 1 Axislength 2", "capsule A 0_0_0 B 0_1_0 radius 1", "capsule A 0_0_0 B 0_0_0 radius 1",
        "truncone A 0_0_0 B 0_1_0 radiusA 1 radiusB 0", "torus rotationalRadius 2 circunferenceRadius 1",
        "ellipsoid a 1 b 2 c 3", "egg a 1 b 2 w 1").stream().map(LightingTest::model).collect(Collectors.joining());
    final String objects = "0123456789".chars().mapToObj(id -> "<object><modelId>n" + (char) id + "</modelId>"
        + "<materialId>m</materialId><scaleFactors>1 2 1</scaleFactors></object>").collect(Collectors.joining());
    number = 0;
    final ReadResult reading = files.read(SceneFiles.with("<illumination>false", "<illumination>true")
        .replace("<scene>", "<lights>" + LIGHT + "</lights><materials>" + BRDF + "</materials><scene>" + objects)
        .replace("</models>", models + "</models>"));
    assertEquals(1, reading.problems().size(), reading.problems().toString());
    final List<Object3D> all = reading.scene().orElseThrow().objects().getObjects();
    assertEquals(11, all.size());
    for (final Object3D object : all.subList(0, 10)) {
      assertEquals("PhongLafortune", object.getMaterial().getClass().getSimpleName(), object.toString());
      assertInstanceOf(Color.class, object.getColor());
    }
  }

  private static int number;

  private static String model(final String words) {
    final String[] word = words.split(" ");
    final StringBuilder model = new StringBuilder("<model id=\"n" + number++ + "\" type=\"" + word[0] + "\">");
    for (int i = 1; i < word.length; i += 2) {
      model.append('<').append(word[i]).append('>').append(word[i + 1].replace('_', ' ')).append("</").append(word[i])
          .append('>');
    }
    return model + "</model>";
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
    "egg|<a>1</a><b>1</b><w>1</w>|27:18: `b` must be greater than `w`: found `1` and `1`",
    "truncone|<A>1 2 3</A><B>1 2 3</B><radiusA>1</radiusA><radiusB>1</radiusB>|27:22: `B` must differ from `A`: both are "
        + "`1 2 3`",
    "truncone|<A>0 0 0</A><B>1 2 3</B><radiusA>0</radiusA><radiusB>0</radiusB>|27:60: `radiusA` and `radiusB` are both 0: "
        + "expected at least one greater than 0"})
  void wrongEggsAndConesAreErrors(final String type, final String values, final String message) {
    assertProblems(files.readModel(type, values), message);
  }

  @Test
  void messagesAreInSpanishToo() {
    final String range = "14:48: `exposure` está fuera de rango: se encontró `21`, se esperaba un número como 2.5, "
        + "-20 <= exposure <= 20";
    final String matte = "34:7: aviso: `color` sin `materialId`: con iluminación el objeto es mate, de este color";
    SceneFiles.in(new Locale("es", "ES"),
        () -> assertProblems(read("<exposure>21</exposure>", LIGHT, "", "<color>255 0 0</color>"), range, matte));
  }

  @Test
  void lightingChecksWhatItIsGiven() {
    assertThrows(IllegalArgumentException.class, () -> new Lighting(true, true, null, 0, 0));
    assertThrows(IllegalArgumentException.class, () -> new Lighting(true, true, new LightGroup(), -1, 0));
    assertThrows(IllegalArgumentException.class, () -> new Lighting(true, true, new LightGroup(), 0, 20.5));
    assertThrows(IllegalArgumentException.class, () -> new Lighting(true, true, new LightGroup(), 0, Double.NaN));
  }
}
