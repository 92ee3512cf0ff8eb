package scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;

import diagnostics.Problem;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

class SceneReaderTest {

  @TempDir
  Path folder;

  private SceneFiles files;

  @BeforeEach
  void start() {
    files = new SceneFiles(folder);
  }

  private void assertProblems(final ReadResult reading, final String... lines) {
    assertEquals(List.of(lines), SceneFiles.lines(reading));
    final boolean error = reading.problems().stream().anyMatch(Problem::isError);
    assertEquals(error, reading.scene().isEmpty());
  }

  @Test
  void aSoundSceneIsReadWithoutAWord() {
    final ReadResult reading = files.read(SceneFiles.SOUND);
    assertProblems(reading);
    final SceneFile scene = reading.scene().orElseThrow();
    assertEquals("a ball", scene.name());
    assertEquals(40, scene.width());
    assertEquals(30, scene.height());
    assertEquals(new Color(51, 102, 153), scene.background());
    assertTrue(scene.facing());
    assertEquals(new Point3D(0, 0, 5), scene.camera().getPosition());
    assertEquals(new Vector3D(0, 0, -1), scene.camera().getLook());
    assertEquals(2 * Math.tan(Math.PI / 6), scene.camera().getProjection().getHeight(), 1e-6);
    assertEquals(1.3333 * 2 * Math.tan(Math.PI / 6), scene.camera().getProjection().getWidth(), 1e-6);
    final Hit hit = scene.objects().intersectionWith(new Ray(new Point3D(0, 0, 5), new Vector3D(0, 0, -1)));
    assertEquals(4, hit.getT(), 1e-6);
    assertEquals(Color.RED, hit.getObject().getColor());
  }

  @Test
  void falseLightingChoosesPlainColours() {
    final String engine = "<illumination>false</illumination>";
    assertFalse(files.readWith(engine, engine + "<falseLighting>false</falseLighting>").scene().orElseThrow().facing());
    assertTrue(files.readWith(engine, engine + "<falseLighting> TRUE </falseLighting>").scene().orElseThrow().facing());
  }

  @Test
  void orthographicAspectIsWidthByHeight() {
    final SceneFile scene = files.readWith("<projection type=\"perspective\">\n    <fov>60</fov>",
        "<projection type=\"orthographic\">\n    <height>3</height>").scene().orElseThrow();
    assertEquals(3, scene.camera().getProjection().getHeight(), 1e-6);
    assertEquals(4, scene.camera().getProjection().getWidth(), 1e-3);
  }

  @Test
  void allProblemsAreToldInTheOrderOfTheFile() {
    final String text = SceneFiles.SOUND.replace("<W>40</W>", "<W>0</W>").replace("<fov>60</fov>", "<fov>sixty</fov>")
        .replace("<radius>1</radius>", "<radius>0</radius>").replace("0 1 0</up>", "0 0 1</up>")
        .replace("<modelId>ball", "<modelId>bal").replace("255 0 0", "300 0 0");
    assertProblems(files.read(text),
        "4:8: `W` is out of range: found `0`, expected a whole number, W >= 1",
        "19:9: `up` lies along the view: found `0 0 1`, expected a direction that is not parallel to that from "
            + "`position` to "
            + "`lookAt`",
        "22:10: `fov` is not a number: found `sixty`, expected a number such as 2.5, 0 < fov < 180",
        "27:15: `radius` is out of range: found `0`, expected a number such as 2.5, radius > 0",
        "32:16: `modelId` names nothing: found `bal`, expected an id of this file. Did you mean `ball`?",
        "33:14: `color` is out of range: found `300`, expected a number such as 2.5, 0 <= color <= 255");
  }

  @Test
  void numbersThatNoFloatOrIntHoldsAreNotSaidToBeOutOfRange() {
    assertProblems(files.readWith("<radius>1</radius>", "<radius>1e99</radius>"),
        "27:15: `radius` is outside the range of float: found `1e99`, expected a number such as 2.5, radius > 0, "
            + "in absolute value from 1.4e-45 to 3.4e38");
    assertProblems(files.readWith("<radius>1</radius>", "<radius>+0.05e-99</radius>"),
        "27:15: `radius` is outside the range of float: found `+0.05e-99`, expected a number such as 2.5, radius > 0, "
            + "in absolute value from 1.4e-45 to 3.4e38");
    assertProblems(files.readWith("<radius>1</radius>", "<radius>-1e99</radius>"),
        "27:15: `radius` is out of range: found `-1e99`, expected a number such as 2.5, radius > 0");
    assertProblems(files.readWith("<radius>1</radius>", "<radius>0.0e9</radius>"),
        "27:15: `radius` is out of range: found `0.0e9`, expected a number such as 2.5, radius > 0");
    assertProblems(files.readWith("<W>40</W>", "<W>2147483648</W>"),
        "4:8: `W` is too large: found `2147483648`, expected a whole number, W >= 1, at most 2147483647");
  }

  /** Each of these texts, repeated some hundred thousand times in a file, once took minutes to read. */
  @ParameterizedTest
  @ValueSource(strings = {"<object><x/></object>", "<object><modelId>bal</modelId></object>",
    "<model id='ID' type='sphere'/><object><modelId>ID0</modelId></object>"})
  void filesMadeOfProblemsAreReadSoon(final String text) {
    final StringBuilder many = new StringBuilder("<image><models/><scene>");
    for (int i = 0; i < 100_000; i++) {
      many.append(text.replace("ID", Integer.toString(i)));
    }
    final ReadResult reading = assertTimeoutPreemptively(Duration.ofSeconds(20), () -> files.read(many
        + "</scene></image>"));
    assertTrue(reading.scene().isEmpty());
    assertEquals(Problems.MOST + 1, reading.problems().size());
    final Problem last = reading.problems().get(Problems.MOST);
    assertTrue(last.isError() && last.message().startsWith("further problems that are not shown: "),
        last::toString);
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void aFileWithoutAnEndIsTooLarge() {
    assertEquals("[/dev/zero: the file is larger than 64 MB: that is not a scene file]",
        SceneReader.read(Path.of("/dev/zero")).problems().toString());
  }

  /** Found by the fuzzer, seed 5094029 of SCENE_BYTES. */
  @Test
  void aLineEndInANameDoesNotBreakAMessage() {
    final String message = files.readModel("mesh", "<objFile>me\nsh\u007f.obj</objFile>").problems().get(0).message();
    assertTrue(message.startsWith("there is no mesh file `me sh .obj`: looked for "), message);
    assertTrue(message.endsWith("me sh .obj") && message.lines().count() == 1, message);
  }

  @ParameterizedTest
  @ValueSource(strings = {"<!-- <W> --><raster/>", "ñ<x/>"})
  void filesMadeOfWarningsAreReadSoon(final String text) {
    final ReadResult reading = assertTimeoutPreemptively(Duration.ofSeconds(20), () -> files.read("<image><models/><scene>"
        + text.repeat(100_000) + "</scene></image>"));
    assertTrue(reading.problems().size() < 40, reading.problems().toString());
  }

  @Test
  void warningsAreNoErrorsHoweverMany() {
    final StringBuilder many = new StringBuilder();
    for (int i = 0; i < 2 * Problems.MOST; i++) {
      many.append("<x").append(i).append("/>");
    }
    final ReadResult reading = files.readWith("<raster>", many + "<raster>");
    assertTrue(reading.scene().isPresent());
    assertEquals("warning: further problems that are not shown: " + Problems.MOST,
        reading.problems().get(Problems.MOST).toString().replaceFirst("^[^:]*:3:\\d+: ", ""));
  }

  @Test
  void aWarningThatRepeatsIsShownTenTimesAndThenCounted() {
    final String line = "<object><modelId>ball</modelId><color>1 120 40</color></object>\n";
    final ReadResult reading = files.readWith("<scene>", "<scene>\n" + line.repeat(5_000) + "<x/>".repeat(11)
        + "<y/>".repeat(10) + "<W>0</W>");
    final List<String> lines = SceneFiles.lines(reading);
    final String mixed = "warning: `color` mixes the ranges 0-1 and 0-255: `1 120 40` is taken as 0-255";
    assertEquals(11 + 11 + 10 + 1, lines.size(), lines.toString());
    assertEquals("31:39: " + mixed, lines.get(0));
    assertEquals("40:39: " + mixed, lines.get(9));
    assertEquals("41:39: warning: 4990 more like this, the first of them here: " + mixed.substring("warning: ".length()),
        lines.get(10));
    assertEquals("5031:41: warning: 1 more like this, the first of them here: unknown element `x` in `scene`.",
        lines.get(21));
    assertEquals("5031:81: warning: unknown element `y` in `scene`.", lines.get(31));
    assertTrue(lines.get(32).contains("`W` is out of place"), lines.get(32));
    assertTrue(reading.scene().isPresent());
  }

  @Test
  void aRepeatedWarningIsCountedInSpanish() {
    SceneFiles.in(new Locale("es", "ES"), () -> assertEquals(
        "3:43: aviso: 3 más como este, el primero aquí: elemento desconocido `x` en `image`.",
        SceneFiles.lines(files.readWith("<raster>", "<x/>".repeat(13) + "<raster>")).get(10)));
  }

  @Test
  void aRasterThatNoArrayHoldsIsAnErrorOfTheFile() {
    assertProblems(files.readWith("<W>40</W>", "<W>2147483647</W>"),
        "4:8: an image of 2147483647 x 30 pixels is too large: at most 2147483639 pixels are possible");
  }

  @ParameterizedTest
  @CsvSource({"00a0, NO-BREAK SPACE", "2009, THIN SPACE", "3000, IDEOGRAPHIC SPACE", "200b, ZERO WIDTH SPACE",
    "feff, ZERO WIDTH NO-BREAK SPACE", "202f, NARROW NO-BREAK SPACE", "2028, LINE SEPARATOR", "85, NEXT LINE (NEL)"})
  void whatOnlyLooksLikeABlankIsNamedWhereItStands(final String code, final String name) {
    final String odd = Character.toString(Integer.parseInt(code, 16));
    final String named = "contains the character U+" + ("0000" + code.toUpperCase(Locale.ROOT)).substring(code.length())
        + " " + name + ", which only looks like a blank";
    assertProblems(files.readWith("<position>0 0 5", "<position>0" + odd + "0" + odd + "5"),
        "17:16: warning: `position` " + named + "; read as one");
    assertProblems(files.readWith("<W>40", "<W>" + odd + "40" + odd), "4:8: warning: `W` " + named + "; read as one");
    assertProblems(files.readWith("<modelId>ball", "<modelId>ball" + odd), "32:20: warning: `modelId` " + named);
    assertProblems(files.readWith("id=\"ball\"", "id=\"" + odd + "ball\""), "26:12: warning: `id` " + named);
    assertProblems(files.readWith("  <raster>", odd + "<raster>"), "3:1: warning: `image` " + named + "; read as one");
    final String tag = SceneFiles.lines(files.readWith("<model id", "<model" + odd + "id")).get(0);
    assertTrue(tag.startsWith("26:11: in the tag `<model` found ") && tag.contains(name), tag);
  }

  @Test
  void messagesAreInSpanishWhereTheLocaleIs() {
    SceneFiles.in(new Locale("es", "ES"), () -> {
      assertProblems(files.readWith("<W>40</W>", "<W>cuarenta</W><ancho>1</ancho><backgroudColor>1</backgroudColor>"),
          "4:8: `W` no es un número entero: se encontró `cuarenta`, se esperaba un número entero, W >= 1",
          "4:20: aviso: elemento desconocido `ancho` en `raster`.",
          "4:36: aviso: elemento desconocido `backgroudColor` en `raster`. ¿Quiso decir `backgroundColor`?");
    });
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
    "raster|<raster>|</raster>|an element <raster>",
    "rayTracer|<rayTracer>|</rayTracer>|an element <rayTracer>",
    "engine|<engine>|</engine>|an element <engine>",
    "camera|<camera>|</camera>|an element <camera>",
    "projection|<projection type=\"perspective\">|</projection>|an element <projection>",
    "scene|<scene>|</scene>|an element <scene>"})
  void aMissingSectionIsNamed(final String name, final String open, final String close, final String expected) {
    final String text = SceneFiles.SOUND;
    final int from = text.indexOf(open), to = text.indexOf(close) + close.length();
    assertProblems(files.read(text.substring(0, from) + text.substring(to)),
        "2:1: `image` lacks `" + name + "`: expected " + expected + ".");
  }

  @Test
  void repeatedValuesCountOnce() {
    final ReadResult reading = files.readWith("<W>40</W>", "<W>40</W> <W>50</W>");
    assertProblems(reading, "4:15: warning: a second `W` in `raster` is ignored: the one of line 4 counts");
    assertEquals(40, reading.scene().orElseThrow().width());
  }

  @Test
  void wrappersAreHarmlessButTold() {
    final ReadResult reading = files.readWith("<radius>1</radius>", "<size><radius>1</radius></size>");
    assertProblems(reading, "27:7: warning: unknown element `size` in `model`.");
  }

  @Test
  void aNameOutOfPlaceIsTold() {
    assertProblems(files.readModel("sphere", "<radius>1</radius><color>1 0 0</color>"),
        "27:25: warning: `color` is out of place in `model`: it belongs in `object`");
    assertProblems(files.readModel("sphere", "<radius>1</radius><Axislength>1</Axislength>"),
        "27:25: warning: `Axislength` has no effect in `model` of type `sphere`");
    assertProblems(files.readModel("sphere", "<radius>1</radius><center>1 0 0</center>"),
        "27:25: warning: `center` is a name of another edition and is ignored: the centre of a sphere is the "
            + "`translation` of "
            + "its object");
  }

  @Test
  void anUnknownAttributeIsTold() {
    assertProblems(files.readWith("<model id=", "<model Id=\"x\" id="),
        "26:12: warning: unknown attribute `Id` of `model`. Did you mean `id`?");
    assertProblems(files.readWith("<image name=\"a ball\">", "<image xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\""
        + " xsi:noNamespaceSchemaLocation=\"scene.xsd\">"));
  }

  @Test
  void aLaterModelOfTheSameIdCounts() {
    final ReadResult reading = files.readWith("</models>",
        "  <model id=\"ball\" type=\"sphere\"><radius>2</radius></model></models>");
    assertProblems(reading, "29:12: warning: a second `model` of id `ball`: the last one counts");
    final Ray ray = new Ray(new Point3D(0, 0, 5), new Vector3D(0, 0, -1));
    assertEquals(3, reading.scene().orElseThrow().objects().intersectionWith(ray).getT(), 1e-6);
  }

  @Test
  void aModelThatIsNotSupportedMattersOnlyWhereItIsShown() {
    final String genus2 = "<model id=\"e\" type=\"genus2\"></model>";
    assertProblems(files.readWith("</models>", genus2 + "</models>"));
    assertProblems(files.read(SceneFiles.with("</models>", genus2 + "</models>").replace("<modelId>ball", "<modelId>e")),
        "32:16: model `e` is of type `genus2`, which is not supported yet: expected one of sphere, box, plane, cylinder, "
            + "capsule, truncone, torus, ellipsoid, egg, mesh");
  }

  @Test
  void aFileThatIsNotThereIsToldWithoutAPlace() {
    final Path none = folder.resolve("none.xml");
    assertEquals(none + ": there is no such file", SceneReader.read(none).problems().get(0).toString());
    assertEquals(folder + ": this is a folder, not a scene file", SceneReader.read(folder).problems().get(0).toString());
    assertThrows(IllegalArgumentException.class, () -> SceneReader.read(null));
  }

  @Test
  void whatIsNoSceneIsQuotedBriefly() {
    assertProblems(files.read("Lorem ipsum dolor sit amet, consectetur adipisicing elit, sed do eiusmod tempor"),
        "1:1: `Lorem ipsum dolor sit amet, consectet...` is outside the document element: expected "
            + "only comments before and after it",
        "1:1: this is not a scene: found `Lorem ipsum dolor sit amet, consectet...`, expected XML with an element `image`");
    assertProblems(files.read("<html><body/></html>"), "1:1: the document element is `html`, expected `image`.");
    assertProblems(files.read("<imagen/>"), "1:1: the document element is `imagen`, expected `image`. Did you mean "
        + "`image`?");
    assertProblems(SceneReader.read(files.write("picture.png", new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0})),
        "1:1: warning: the file is not encoded in `UTF-8`; read as Latin-1",
        "2:1: the character of code 1a (hexadecimal) must not occur in XML: is this a scene file?");
  }

  @Test
  void theImageMayBeInsideAnotherElement() {
    final String wrapped = SceneFiles.SOUND.replace("<image name=\"a ball\">", "<all><image>") + "</all>";
    assertProblems(files.read(wrapped), "2:1: warning: the document element is `all`, expected `image`; it is looked "
        + "for inside");
  }

  @Test
  void documentTypesAreRefused() {
    final String bomb = "<!DOCTYPE image [<!ENTITY a \"x\"><!ENTITY b SYSTEM \"file:///etc/hostname\">]>\n<image>";
    assertProblems(files.readWith("<image name=\"a ball\">", bomb),
        "2:1: `<!DOCTYPE` is refused: a scene file has no document type and no entities of its own");
  }

  @Test
  void byteOrderMarksAndLatin1CommentsDoNoHarm() {
    final byte[] plain = SceneFiles.SOUND.getBytes(StandardCharsets.UTF_8);
    final byte[] marked = new byte[plain.length + 3];
    marked[0] = (byte) 0xef;
    marked[1] = (byte) 0xbb;
    marked[2] = (byte) 0xbf;
    System.arraycopy(plain, 0, marked, 3, plain.length);
    assertProblems(SceneReader.read(files.write("utf8.xml", marked)));
    final String accented = SceneFiles.with("<raster>", "<!-- cámara --><raster>");
    assertProblems(SceneReader.read(files.write("u.xml", accented.getBytes(StandardCharsets.UTF_8))));
    for (final String wide : List.of("UTF-16LE", "UTF-16BE", "UTF-32LE", "UTF-32BE")) {
      for (final String text : List.of("\ufeff" + accented, accented, accented.replace("?>", " encoding='" + wide + "'?>"),
          accented.substring(accented.indexOf("<image")))) {
        assertProblems(SceneReader.read(files.write("wide.xml", text.getBytes(Charset.forName(wide)))));
      }
    }
    assertProblems(SceneReader.read(files.write("l.xml", accented.getBytes(StandardCharsets.ISO_8859_1))),
        "1:1: warning: the file is not encoded in `UTF-8`; read as Latin-1");
    final String declared = accented.replace("?>", " encoding='ISO-8859-1'?>");
    assertProblems(SceneReader.read(files.write("d.xml", declared.getBytes(StandardCharsets.ISO_8859_1))));
    final String narrow = accented.replace("?>", " encoding='utf-16'?>");
    assertProblems(SceneReader.read(files.write("n.xml", narrow)), "1:1: warning: the file is not encoded in `utf-16`, as "
        + "it declares: each letter is one byte; read as UTF-8");
    assertProblems(SceneReader.read(files.write("e.xml", " \n")), "1:1: the file is empty: expected XML with an element "
        + "`image`");
    final String unknown = accented.replace("?>", " encoding=\"klingon\"?>");
    assertProblems(SceneReader.read(files.write("k.xml", unknown)),
        "1:1: warning: the encoding `klingon` of the XML declaration is not known; read as UTF-8");
  }

  @Test
  void columnsCountCharactersAndLinesEndInThreeWays() {
    final String text = SceneFiles.with("<W>40</W>", "<!-- ñandú 🚀 --><W>x</W>");
    final String expected = "`W` is not a whole number: found `x`, expected a whole number, W >= 1";
    assertProblems(files.read(text), "4:24: " + expected);
    assertProblems(files.read(text.replace("\n", "\r\n")), "4:24: " + expected);
    assertProblems(files.read(text.replace("\n", "\r")), "4:24: " + expected);
  }
}
