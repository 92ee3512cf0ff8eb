package scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Locale;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import trials.Trials;

/** Textures, material files, normals and coordinates of meshes in scene files. */
class MeshAppearanceTest {

  /** The square from (−1, −1) to (1, 1), the image upright on it. */
  private static final String SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
  private static final String FACET = "f 1/1 2/2 3/3 4/4\n";

  /** A JPEG file of one pixel: cyan 121, magenta 255, yellow 71, no black. */
  private static final String INKS = "/9j/7gAOQWRvYmUAZAAAAAAA/9sAQwADAgIDAgIDAwMDBAMDBAUIBQUEBAUKBwcGCAwKDAwLCgsLDQ4SEA0O"
      + "EQ4LCxAWEBETFBUVFQwPFxgWFBgSFBUU/8AAFAgAAQABBEMRAE0RAFkRAEsRAP/EAB8AAAEFAQEBAQEBAAAA"
      + "AAAAAAABAgMEBQYHCAkKC//EALUQAAIBAwMCBAMFBQQEAAABfQECAwAEEQUSITFBBhNRYQcicRQygZGhCCNC"
      + "scEVUtHwJDNicoIJChYXGBkaJSYnKCkqNDU2Nzg5OkNERUZHSElKU1RVVldYWVpjZGVmZ2hpanN0dXZ3eHl6"
      + "g4SFhoeIiYqSk5SVlpeYmZqio6Slpqeoqaqys7S1tre4ubrCw8TFxsfIycrS09TV1tfY2drh4uPk5ebn6Onq"
      + "8fLz9PX29/j5+v/aAA4EQwBNAFkASwAAPwDQr8qq+la/VOv/2Q==";

  @TempDir
  Path folder;

  private SceneFiles files;

  @BeforeEach
  void start() {
    files = new SceneFiles(folder);
  }

  private static byte[] image(final String format, final BufferedImage image) {
    try (ByteArrayOutputStream bytes = new ByteArrayOutputStream()) {
      ImageIO.write(image, format, bytes);
      return bytes.toByteArray();
    } catch (final IOException impossible) {
      throw new UncheckedIOException(impossible);
    }
  }

  /** Red and green above blue and white. (Of 2 x 2 pixels the JDK makes GIF files that it cannot read.) */
  private static BufferedImage quarters(final int type) {
    final BufferedImage image = new BufferedImage(16, 16, type);
    for (int i = 0; i < 256; i++) {
      final int column = i % 16 / 8, row = i / 128;
      image.setRGB(i % 16, i / 16, row == 0 ? column == 0 ? 0xFFFF0000 : 0xFF00FF00 : column == 0 ? 0xFF0000FF : 0xFFFFFFFF);
    }
    return image;
  }

  private ReadResult read(final String mesh, final String model, final String object) {
    files.write("m.obj", mesh);
    return files.read(SceneFiles.SOUND.replace("<model id=\"ball\" type=\"sphere\">\n      <radius>1</radius>",
        "<model id=\"ball\" type=\"mesh\">\n      <objFile>m.obj</objFile>" + model)
        .replace("<color>255 0 0</color>", object));
  }

  private static Hit hit(final ReadResult reading, final double x, final double y) {
    final SceneFile scene = reading.scene().orElseThrow(() -> new AssertionError(reading.problems()));
    return scene.objects().intersectionWith(new Ray(new Point3D((float) x, (float) y, 9), new Vector3D(0, 0, -1)));
  }

  private static Color colour(final ReadResult reading, final double x, final double y) {
    final Hit hit = hit(reading, x, y);
    return hit.getObject().getColorAt(hit);
  }

  private static List<String> warnings(final ReadResult reading) {
    return reading.problems().stream().map(problem -> problem.file().replaceFirst(".*[/\\\\]", "") + ":" + problem.line()
        + ": " + problem.message()).toList();
  }

  @ParameterizedTest
  @ValueSource(strings = {"png", "gif", "bmp"})
  void imagesStandUprightOnMeshesAndSpheres(final String format) {
    files.write("a.image", image(format, quarters(BufferedImage.TYPE_INT_RGB)));
    final ReadResult mesh = read(SQUARE + FACET, "", "<textureFile>a.image</textureFile>");
    assertEquals(List.of(), mesh.problems());
    final ReadResult ball = files.readWith("<color>255 0 0</color>", "<textureFile>a.image</textureFile>");
    for (final ReadResult reading : List.of(mesh, ball)) {
      assertEquals(Color.RED, colour(reading, -0.3, 0.3));
      assertEquals(Color.GREEN, colour(reading, 0.3, 0.3));
      assertEquals(Color.BLUE, colour(reading, -0.3, -0.3));
      assertEquals(Color.WHITE, colour(reading, 0.3, -0.3));
    }
    final ReadResult turned = files.readWith("<color>255 0 0</color>",
        "<textureFile>a.image</textureFile><rotationAxis>0 0 1</rotationAxis><rotationAngle>90</rotationAngle>");
    assertEquals(Color.GREEN, colour(turned, -0.3, 0.3));
  }

  @Test
  void greyIsTheNumberThatIsStored() {
    final BufferedImage grey = new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_GRAY);
    grey.getRaster().setSample(0, 0, 0, 20);
    files.write("a.png", image("png", grey));
    assertEquals(new Color(20, 20, 20), colour(read(SQUARE + FACET, "", "<textureFile>a.png</textureFile>"), 0.1, 0));
  }

  @Test
  void facetsWithoutTextureCoordinatesHaveTheMeanColour() {
    files.write("a.png", image("png", quarters(BufferedImage.TYPE_INT_RGB)));
    final ReadResult reading = read(SQUARE + "v 3 0 0\nf 2 5 3\n" + FACET, "", "<textureFile>a.png</textureFile>");
    assertEquals(List.of("m.obj:10: facets without texture coordinates have the mean colour of the texture, the first in "
        + "this line"), warnings(reading));
    assertEquals(new Color(128, 128, 128), colour(reading, 1.5, 0));
  }

  @Test
  void texturesThatCannotBeUsedAreErrors() {
    final byte[] png = image("png", quarters(BufferedImage.TYPE_INT_RGB));
    files.write("cut.png", Arrays.copyOf(png, png.length / 2));
    files.write("text.png", "no image");
    files.write("empty.png", "");
    final byte[] large = png.clone();
    large[17] = 1;
    large[21] = 1;
    files.write("large.png", large);
    final byte[] jpeg = image("jpeg", new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB));
    files.write("cut.jpg", Arrays.copyOf(jpeg, jpeg.length * 2 / 3));
    for (final String name : List.of("cut.png", "text.png", "empty.png", "large.png", "cut.jpg", "none.png")) {
      final ReadResult reading = read(SQUARE + FACET, "", "<textureFile>" + name + "</textureFile>");
      assertEquals(1, reading.problems().size(), reading.problems()::toString);
      assertTrue(reading.problems().get(0).isError() && reading.problems().get(0).line() == 33
          && reading.problems().get(0).message().contains(name), reading.problems()::toString);
    }
    files.write("a.png", png);
    assertEquals(List.of("scene.xml:33: the mesh has no texture coordinates (`vt`), which a `textureFile` needs"),
        warnings(read(SQUARE + "f 1 2 3\n", "", "<textureFile>a.png</textureFile>")));
  }

  @Test
  void aTextureCountsBeforeAColour() {
    files.write("a.png", image("png", quarters(BufferedImage.TYPE_INT_RGB)));
    final ReadResult reading = read(SQUARE + FACET, "", "<color>9 9 9</color><textureFile>a.png</textureFile>");
    assertEquals(List.of(), reading.problems());
    assertEquals(Color.RED, colour(reading, -0.5, 0.5));
  }

  private ReadResult readMaterial(final String materials) {
    files.write("my materials.mtl", materials);
    return read("mtllib my materials.mtl\n" + SQUARE + "usemtl Material #25\n" + FACET, "", "");
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {"Kd 1 0 0|ff0000|255", "Kd 0.5|808080|255", "Kd 2 -1 0.2|ff0033|255",
    "Kd spectral a.rfl|cccccc|255", "Kd 0 0 1;d 0.5|0000ff|128", "Kd 0 0 1;Tr 0.25|0000ff|191", "d 0|cccccc|255",
    "Tr 1|cccccc|255", "Tr 0.3;d 0.5|cccccc|128", "d 0.5;Tr 0.3|cccccc|128", "d -halo 0.5|cccccc|128",
    "d 0.5 x # 1|cccccc|128",
    "Ka 1 1 1;Ns x|cccccc|255",
    "map_Kd none.png;Kd 0 1 0|00ff00|255"})
  void materialsGiveColourAndOpacity(final String properties, final String rgb, final int alpha) {
    final ReadResult reading = readMaterial("# one\nnewmtl Material #25\n" + properties.replace(';', '\n')
        + "\nnewmtl Material #25\nKd 0.1 0.1 0.1\n");
    final Color color = colour(reading, 0.1, 0);
    assertEquals(rgb, String.format(Locale.ROOT, "%06x", color.getRGB() & 0xFFFFFF));
    assertEquals(alpha, color.getAlpha());
    assertEquals(properties.contains("map_Kd") ? List.of("my materials.mtl:3: there is no texture file "
        + "`none.png` beside the material file: its facets have the colour Kd") : List.of(), warnings(reading));
  }

  @Test
  void texturesOfMaterialsTakeThePlaceOfTheirColour() {
    files.write("the map.png", image("png", quarters(BufferedImage.TYPE_INT_RGB)));
    final ReadResult reading = readMaterial("newmtl Material #25\nKd 0 0 0\nd 0.5\n"
        + "map_Kd -clamp on -o 0.5 0 -mm 0 1 C:\\maps\\the map.png\n");
    assertEquals(new Color(255, 0, 0, 128), colour(reading, -0.5, 0.5));
    assertEquals(List.of("my materials.mtl:4: the options -o, -s and -t of the texture "
        + "`C:\\maps\\the map.png` have no effect"),
        warnings(reading));
    assertTrue(reading.scene().orElseThrow().meshes().contains(folder.resolve("the map.png")));
    assertTrue(reading.scene().orElseThrow().meshes().contains(folder.resolve("my materials.mtl")));
  }

  @Test
  void optionsOfTexturesAreReadWithTheirArguments() {
    files.write("the map.png", image("png", quarters(BufferedImage.TYPE_INT_RGB)));
    for (final String options : List.of("", "-blendu off ", "-mm 0 1 -texres 512 ", "-o 0 -s 1 1 -t 0 0 0 ",
        "-unknown 7 ")) {
      final ReadResult reading = readMaterial("newmtl Material #25\nmap_Kd " + options + "the map.png\n");
      assertEquals(List.of(), warnings(reading), options);
      assertEquals(Color.RED, colour(reading, -0.5, 0.5), options);
    }
  }

  @Test
  void inksOfAnImageForPrintingAreMultiplied() {
    files.write("inks.jpg", Base64.getDecoder().decode(INKS));
    final Color color = colour(read(SQUARE + FACET, "", "<textureFile>inks.jpg</textureFile>"), 0.1, 0);
    assertEquals(0, Math.max(Math.abs(color.getRed() - 134), Math.max(color.getGreen(), Math.abs(color.getBlue() - 184))), 3,
        color::toString);
  }

  @Test
  void statementsWithoutTheNameOfAFileAreWarnings() {
    assertEquals(List.of("my materials.mtl:2: `map_Kd` names no texture file: its facets have the colour Kd"),
        warnings(readMaterial("newmtl Material #25\nmap_Kd -s 1 1 1 -clamp on\n")));
    assertEquals(List.of("m.obj:1: `mtllib` names no material file"), warnings(read("mtllib\n" + SQUARE + FACET, "", "")));
    assertEquals(List.of("m.obj:9: `usemtl` names no material: the facets after it are light grey"),
        warnings(read(SQUARE + "usemtl \n" + FACET, "", "")));
  }

  @Test
  void whatIsMissingOfMaterialsIsAWarning() {
    final ReadResult reading = read("mtllib a.mtl b.mtl\n" + SQUARE + "usemtl x\n" + FACET + "usemtl x\n" + FACET, "", "");
    assertEquals(List.of("m.obj:1: there is no material file `a.mtl` beside the mesh",
        "m.obj:1: there is no material file `b.mtl` beside the mesh",
        "m.obj:10: no material file has the material `x`: its facets are light grey"), warnings(reading));
    assertEquals(new Color(204, 204, 204), colour(reading, 0.1, 0));
    assertEquals(List.of(), read("mtllib a.mtl\n" + SQUARE + FACET, "", "<color>1 0 0</color>").problems());
    assertEquals(List.of(), read(SQUARE + FACET + "usemtl of no facet\n", "", "").problems());
    assertEquals(1, read(SQUARE + FACET, "", "").problems().size());
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-16LE", "UTF-16BE", "UTF-32LE", "UTF-32BE", "UTF-8", "ISO-8859-1"})
  void meshesAndMaterialsAreReadInAllEncodings(final String charset) throws IOException {
    for (final String mark : List.of("", "\ufeff")) {
      final String start = charset.startsWith("UTF") ? mark : "";
      files.write("n.mtl", (start + "newmtl ñandú\nKd 1 0 0\n").getBytes(charset));
      files.write("m.obj", (start + "mtllib n.mtl\n" + SQUARE + "usemtl ñandú\n" + FACET).getBytes(charset));
      final ReadResult reading = files.read(SceneFiles.SOUND.replace("type=\"sphere\">\n      <radius>1</radius>",
          "type=\"mesh\"><objFile>m.obj</objFile>").replace("<color>255 0 0</color>", ""));
      assertEquals(List.of(), reading.problems());
      assertEquals(Color.RED, colour(reading, 0.1, 0));
    }
    files.write("m.obj", ("# ñ\nv ñ 0 0 x\n").getBytes(Charsets.of(charset)));
    assertEquals("m.obj:2: not a number: found `ñ`, expected a coordinate such as 2.5", warnings(files.read(SceneFiles.SOUND
        .replace("type=\"sphere\">\n      <radius>1</radius>", "type=\"mesh\"><objFile>m.obj</objFile>"))).get(0));
  }

  /** Names of encodings as constants would not fit the list of a test. */
  private static final class Charsets {
    static java.nio.charset.Charset of(final String name) {
      return name.equals("UTF-8") ? StandardCharsets.UTF_8 : java.nio.charset.Charset.forName(name);
    }
  }

  /** Two triangles whose corners all have the normal (0.6, 0, 0.8); the fourth vertex stands up. */
  @ParameterizedTest
  @CsvSource({"'', 0.6, 0.8", "<flat>false</flat>, 0.6, 0.8", "<flat>true</flat>, 0, 1",
      "<flat>true</flat><promediatedNormals>true</promediatedNormals>, 0, 1",
      "<promediatedNormals>true</promediatedNormals>, 0.3162278, 0.9486833"})
  void normalsAreThoseOfTheFileOfTheFacetsOrTheirAverages(final String model, final double x, final double z) {
    final Hit hit = hit(read("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv 2 0 1\nvn 1.2 0 1.6\nf 1//1 2//1 3//1\nf 2//1 4//1 3//1\n",
        model, "<color>1 0 0</color>"), 0.9999, 0);
    assertEquals(x, Math.abs(hit.normalX()), 1e-4);
    assertEquals(z, hit.normalZ(), 1e-4);
    assertEquals(1, hit.geometricZ(), 1e-7);
  }

  private static String moved(final double[][] vertices, final double dx, final double dy, final double dz) {
    final StringBuilder text = new StringBuilder();
    for (final double[] p : vertices) {
      text.append(String.format(Locale.ROOT, "v %.7f %.7f %.7f%n", p[0] + dx, p[1] + dy, p[2] + dz));
    }
    return text + "f 1 2 3\nf 1 3 4\n";
  }

  /** A mesh in the coordinates of a map, with the opposite translation, is the mesh at the origin. */
  @Test
  void meshesFarAwayArePlacedInDoublePrecision() {
    Trials.of(40, random -> {
      final double[][] p = {{-1, -1, 0}, {1, -1, 0.1}, {1, 1, random.nextDouble()}, {-1, 1, 0}};
      final double c = Math.floor(Math.pow(10, 7 * random.nextDouble())) + 0.3, d = -Math.floor(c / 3) - 0.1;
      final String turn = "<rotationAxis>0.3 1 0.1</rotationAxis><rotationAngle>0.7</rotationAngle>";
      final ReadResult near = read(moved(p, 0, 0, 0), "", "<color>1 0 0</color>");
      final ReadResult far = read(moved(p, c, d, -c), "", "<color>1 0 0</color>" + String.format(Locale.ROOT,
          "<translation>%.1f %.1f %.1f</translation>", -c, -d, c));
      assertEquals(List.of(), far.problems());
      for (int i = 0; i < 50; i++) {
        final double x = 1.8 * (random.nextDouble() - 0.5), y = 1.8 * (random.nextDouble() - 0.5);
        assertEquals(hit(near, x, y).getT(), hit(far, x, y).getT(), 4e-6);
        assertEquals(hit(near, x, y).normalX(), hit(far, x, y).normalX(), 1e-5);
      }
      assertTrue(read(moved(p, c, d, -c), "", "<color>1 0 0</color>" + turn).scene().isPresent());
    });
  }

  @Test
  void coordinatesThatNoFloatHoldsArePlacedFirst() {
    final String vertices = "v -1e39 -1e39 0\nv 1e39 -1e39 0\nv 1e39 1e39 0\nv -1e39 1e39 0\nv 1e200 0 0\nf 1 2 3 4\n";
    final ReadResult placed = read(vertices, "", "<color>1 0 0</color><scaleFactors>1e-39 1e-39 1e-39</scaleFactors>");
    assertEquals(List.of(), placed.problems());
    assertEquals(9, hit(placed, 0.9, 0.9).getT(), 1e-5);
    assertFalse(hit(placed, 1.1, 0.9).hits());
    assertEquals(List.of("scene.xml:31: a vertex of the mesh is placed outside the range of float: expected "
        + "coordinates less than 3.4e38"), warnings(read(vertices, "", "<color>1 0 0</color>")));
    final String small = vertices.replace("e39", "e-44");
    final ReadResult large = read(small, "", "<color>1 0 0</color><scaleFactors>1e38 1e38 1e38</scaleFactors>");
    assertTrue(hit(large, 9e-7, -9e-7).hits());
    assertFalse(hit(large, 9e-7, -1.1e-6).hits());
  }

  /** Turned by 45 degrees, a square on its corner has the extent of its sides; the box about it reaches twice as far. */
  @Test
  void farAwayIsSaidOfTheMeshNotOfItsBox() {
    final String square = "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3 4\n";
    for (final int distance : new int[] {14_100, 14_300}) {
      final ReadResult reading = read(square, "", "<color>1 0 0</color><rotationAxis>0 0 1</rotationAxis>"
          + "<rotationAngle>45</rotationAngle><translation>" + distance + " 0 0</translation>");
      assertEquals(distance > 10_000 * Math.sqrt(2) ? 1 : 0, reading.problems().size(), () -> "at " + distance);
    }
  }

  @Test
  void aMeshThatStaysFarAwayIsNamedWithTheTranslationThatHelps() {
    final double[][] p = {{0, 0, 0}, {0.4, 0, 0}, {0.4, 0.4, 0}, {0, 0.4, 0}};
    assertEquals(List.of("scene.xml:31: the mesh is farther from the origin than 10,000 times its size, where "
        + "floats are coarse: "
        + "<translation>-610000.3000 4740000.0000 -450.0000</translation> brings it to the origin"),
        warnings(read(moved(p, 610000.1, -4740000.2, 450), "", "<color>1 0 0</color>")));
  }
}
