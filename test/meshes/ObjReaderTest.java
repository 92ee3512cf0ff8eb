package meshes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import models.MeshData;
import scenes.SceneFiles;
import trials.Trials;

class ObjReaderTest {

  private static final String SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

  @TempDir
  Path folder;

  private SceneFiles files;

  @BeforeEach
  void start() {
    files = new SceneFiles(folder);
  }

  private ObjReader.Result read(final String text) {
    return read(text.getBytes(StandardCharsets.UTF_8));
  }

  private ObjReader.Result read(final byte[] bytes) {
    return new ObjReader(files.write("mesh.obj", bytes), false).read();
  }

  /** The vertices of the triangles of a file that is read without problems. */
  private int[] corners(final String text) {
    final ObjReader.Result reading = read(text);
    assertEquals(List.of(), reading.problems());
    return reading.mesh().flat().corners();
  }

  private void assertProblems(final String text, final String... lines) {
    assertProblems(read(text), lines);
  }

  private static void assertProblems(final ObjReader.Result reading, final String... lines) {
    assertEquals(List.of(lines), reading.problems().stream().map(p -> p.toString().substring(p.file().length() + 1))
        .collect(Collectors.toList()));
  }

  @Test
  void verticesAndFacets() {
    final ObjReader.Result reading = read("v 1 -2.5 3e1\n v\t.5 5. +7 \nv 0 0 0\nf 1 2 3\n");
    assertArrayEquals(new double[] {1, -2.5, 30, 0.5, 5, 7, 0, 0, 0}, reading.mesh().flat().coordinates());
    assertArrayEquals(new int[] {0, 1, 2}, reading.mesh().flat().corners());
  }

  @Test
  void polygonsBecomeFans() {
    assertArrayEquals(new int[] {0, 1, 2, 0, 2, 3}, corners(SQUARE + "f 1 2 3 4"));
    assertArrayEquals(new int[] {0, 1, 2, 0, 2, 3, 0, 3, 4}, corners(SQUARE + "v -1 0 0\nf 1 2 3 4 5"));
    final StringBuilder many = new StringBuilder();
    final StringBuilder facet = new StringBuilder("f");
    for (int i = 1; i <= 3000; i++) {
      many.append("v ").append(Math.cos(i * 2e-3)).append(' ').append(Math.sin(i * 2e-3)).append(" 0\n");
      facet.append(' ').append(i);
    }
    assertEquals(3 * 2998, corners(many.append(facet).toString()).length);
  }

  @ParameterizedTest
  @ValueSource(strings = {"f 1 2 3", "f 1/4 2/5 3/1", "f 1//1 2//1 3//1", "f 1/2/3 2/3/4 3/4/5", "f -4 -3 -2", "f "
      + "-4/-1/-1 -3 -2//-1",
    "f 1 2 \\\n 3", "f \\\r\n1 2\\\n3", "f\t1\t2\t3  ", "f 1 2 3 # a triangle", "f 1 2 3#", "f +1 2 3", "f 1/ 2/ 3/",
    "f 1/+1/+2 2 3"})
  void allFormsOfAFacet(final String facet) {
    final String square = SQUARE + "vt 0 0\n".repeat(5) + "vn 0 0 1\n".repeat(5);
    assertArrayEquals(new int[] {0, 1, 2}, corners(square + facet), facet);
    assertArrayEquals(new int[] {0, 1, 2}, corners((square + facet).replace("\n", "\r\n").replace("\r\r\n", "\r\n")), facet);
    assertArrayEquals(new int[] {0, 1, 2}, corners(square + facet + "\n\n"), facet);
  }

  @Test
  void negativeIndicesCountFromTheirLine() {
    assertArrayEquals(new int[] {0, 1, 2, 1, 2, 3}, corners("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -3 -2 -1\n"));
  }

  @Test
  void blanksThatAreNoneAreNamedWhereTheyStand() {
    assertProblems("v\u00a00 0 0\nv 1 0 0\nv 0\u20091 0\n\u3000v 1 1 1\nf 1 2\u200b3\n",
        "1:2: U+00A0 NO-BREAK SPACE looks like a blank but separates nothing: expected a blank (U+0020)",
        "3:4: U+2009 THIN SPACE looks like a blank but separates nothing: expected a blank (U+0020)",
        "4:1: U+3000 IDEOGRAPHIC SPACE looks like a blank but separates nothing: expected a blank (U+0020)",
        "5:6: U+200B ZERO WIDTH SPACE looks like a blank but separates nothing: expected a blank (U+0020)");
    assertProblems(SQUARE + "vn\ufeff0 0 1\nf 1 2 3\n", "5:3: warning: U+FEFF ZERO WIDTH NO-BREAK SPACE looks like a "
        + "blank but separates nothing: expected a blank (U+0020)");
    corners("# \u00a0v\nusemtl a\u00a0b\n" + SQUARE + "f 1 2 3\n");
  }

  @Test
  void normalsAndTextureCoordinatesThatAreMissingGiveOneWarning() {
    assertProblems(SQUARE + "vn 0 0 1\nvn nan 0 1\nvt x\nf 1/1/1 2/9/2 3//7\nf 1 3 4\n",
        "6:1: warning: normals or texture coordinates that are missing or not numbers: 4, the first in this line");
    assertProblems(SQUARE + "vt 0.5\nvt 1 1 0\nvn 0 0 0\nf 1/1/1 2/-1/-1 3/2\n");
  }

  @Test
  void aPolygonThatCrossesItselfIsReportedTwentyTimesAtMost() {
    final ObjReader.Result reading = read(SQUARE + "f 1 2 4 3\n".repeat(25));
    assertEquals(21, reading.problems().size());
    assertEquals("this polygon of 4 corners crosses itself or has no area: it is drawn as the fan of its first corner",
        reading.problems().get(0).message());
    assertEquals(5, reading.problems().get(0).line());
  }

  /** Arrays that grow by half have lengths that are no multiple of 3 from some hundred thousand numbers on. */
  @Test
  void manyNormalsAndTextureCoordinatesAreRead() {
    final int many = 300_000;
    final ObjReader.Result reading = new ObjReader(files.write("many.obj", ("v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        + "vn 0 1 0\n".repeat(many - 1) + "vn 1 0 0\n" + "vt 0 1\n".repeat(many - 1) + "vt 2 3\n"
        + "v 0 0 1\n".repeat(many) + "f 1/1/1 2/" + many + "/" + many + " " + (many + 3) + "\n")
        .getBytes(StandardCharsets.UTF_8)), true).read();
    assertEquals(List.of(), reading.problems());
    assertArrayEquals(new int[] {0, 1, many + 2}, reading.mesh().flat().corners());
    final MeshData smooth = reading.mesh().smooth();
    assertEquals(1, smooth.normals().values()[3 * smooth.normals().corners()[1]]);
    assertEquals(3, smooth.texCoords().values()[2 * smooth.texCoords().corners()[1] + 1]);
  }

  @Test
  void aPolygonOfAVertexAtFaultIsNotBlamed() {
    assertProblems(SQUARE + "v 1 2\nf 1 2 3 5 4\n", "5:1: a vertex has fewer than three numbers: expected `v x y z`");
  }

  @Test
  void aFileOfLinesIsCalledWhatItIs() {
    assertProblems(SQUARE + "l 1 2\nl 2 3 4\np 1\n", "1:1: there is no facet (`f`), only lines or curves: 2, and "
        + "points: 1; a mesh needs facets");
  }

  @Test
  void aZipFileWhoseFirstEntryIsNoMeshIsSearchedForOne() throws IOException {
    final ObjReader.Result reading = read(zip("m.mtl", "newmtl a\n", "__MACOSX/._b.obj", "x", "b.obj", SQUARE
        + "f 1 2 x\n"));
    assertEquals(folder.resolve("mesh.obj") + "!b.obj", reading.problems().get(0).file());
    assertEquals(5, reading.problems().get(0).line());
    assertEquals(folder.resolve("mesh.obj") + "!m.mtl", read(zip("m.mtl", "newmtl a\n")).problems().get(0).file());
  }

  @Test
  void otherStatementsArePassedOverAsLines() {
    final String noise = "# f 1 2 v vn\nvn 0 0 1\nvt 0 0\no v f\ng f 9 9 9\ns 1\nusemtl v\nmtllib a.mtl\n\n  \nl 1 2 "
        + "\\\nf 7 8 9\nfo 1 2 3\n"
        + "# a comment is not continued \\\nvp 1\n";
    assertArrayEquals(new int[] {0, 1, 2}, corners(noise + SQUARE + noise + "f 1 2 3\n" + noise));
  }

  @Test
  void coloursOfVerticesAndOtherNumbersArePassedOver() {
    final ObjReader.Result reading = read("v 0 0 0 1 0.5 0\nv 1 0 0 1\nv 0 1 0 x y z\nf 1 2 3\n");
    assertArrayEquals(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, reading.mesh().flat().coordinates());
  }

  @Test
  void marksAndEncodingsDoNoHarm() {
    final byte[] latin1 = ("# ñandú\n" + SQUARE + "f 1 2 3").getBytes(StandardCharsets.ISO_8859_1);
    assertEquals(3, read(latin1).mesh().flat().corners().length);
    assertEquals(3, corners("\ufeff" + SQUARE + "f 1 2 3").length);
    assertEquals(3, corners((SQUARE + "f 1 2 3").replace('\n', '\r')).length);
    assertProblems((SQUARE + "f 1 2 x").replace('\n', '\r'), "5:7: not a corner of a facet: found `x`, expected i, "
        + "i/t, i//n or i/t/n");
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {
    "v 1 2|5:1: a vertex has fewer than three numbers: expected `v x y z`",
    "v|5:1: a vertex has fewer than three numbers: expected `v x y z`",
    "v 1 two 3|5:5: not a number: found `two`, expected a coordinate such as 2.5",
    "v 1 2,5 3|5:5: not a number: found `2,5`, expected a coordinate such as 2.5",
    "v 1 -1e309 3|5:5: the coordinate `-1e309` is too large: expected at most 1.8e308 in absolute value",
    "v nan 0 0|5:3: not a number: found `nan`, expected a coordinate such as 2.5",
    "f 1 2|5:1: a facet of 2 corners: expected three or more, `f a b c`",
    "f|5:1: a facet of 0 corners: expected three or more, `f a b c`",
    "f 1 2 5|5:7: there is no vertex 5 before this line: 4 vertices so far",
    "f 0 1 2|5:3: there is no vertex 0 before this line: 4 vertices so far",
    "f 1 -5 2|5:5: there is no vertex -5 before this line: 4 vertices so far",
    "f 1 2 99999999999|5:7: there is no vertex 99999999999 before this line: 4 vertices so far",
    "f 1 2 99999999999999999999999|5:7: not a corner of a facet: found `99999999999999999999999`, expected i, i/t, "
        + "i//n or i/t/n",
    "f 1 2 3.5|5:7: not a corner of a facet: found `3.5`, expected i, i/t, i//n or i/t/n",
    "f 1 /2 3|5:5: not a corner of a facet: found `/2`, expected i, i/t, i//n or i/t/n",
    "f 1 2 abc|5:7: not a corner of a facet: found `abc`, expected i, i/t, i//n or i/t/n",
    "f - 2 3|5:3: not a corner of a facet: found `-`, expected i, i/t, i//n or i/t/n"})
  void errorsHaveLineAndColumn(final String statement, final String message) {
    assertProblems(SQUARE + statement + "\nf 1 2 3\n", message);
    assertNull(read(SQUARE + statement + "\n").mesh());
  }

  @Test
  void allErrorsAreToldUpToALimit() {
    assertProblems("v 1 2\nv x 0 0\nf 1 2 9\n", "1:1: a vertex has fewer than three numbers: expected `v x y z`",
        "2:3: not a number: found `x`, expected a coordinate such as 2.5", "3:7: there is no vertex 9 before this "
            + "line: 2 vertices so far");
    final ObjReader.Result many = read("v 1 2\n".repeat(1000));
    assertEquals(ObjReader.MOST_ERRORS + 1, many.problems().size());
    assertTrue(many.problems().get(ObjReader.MOST_ERRORS).message().startsWith("20 errors up to here"));
    assertEquals(ObjReader.MOST_ERRORS, read("v 1 2\n".repeat(ObjReader.MOST_ERRORS)).problems().size());
  }

  @Test
  void trianglesWithoutAreaAreDroppedWithOneWarning() {
    final ObjReader.Result reading = read(SQUARE + "v 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 5\nf 1 3 4\n");
    assertProblems(reading, "7:1: warning: triangles without area that are left out: 2, the first in this line");
    assertArrayEquals(new int[] {0, 1, 2, 0, 2, 3}, reading.mesh().flat().corners());
    assertProblems(SQUARE + "f 1 2 2\n", "1:1: no facet has an area; triangles left out: 1");
  }

  @Test
  void aFileWithoutFacetsIsNoMesh() {
    assertProblems("", "1:1: there is no facet: is this a Wavefront OBJ file?");
    assertProblems(SQUARE, "1:1: there is no facet (`f`), only 4 vertices: a mesh needs facets");
    final byte[] noise = new byte[100_000];
    new Random(7).nextBytes(noise);
    assertNull(read(noise).mesh());
  }

  @Test
  void wordsAcrossTheEdgesOfTheWindowAreWhole() {
    for (int padding = 65_400; padding < 65_600; padding++) {
      final String text = "#" + "x".repeat(padding) + "\nv 1.25 2.25 3.25\nv 4 5 6\nv 7 8 10\nvt 0 0\nvn 0 0 1\n"
          + "f 1/1/1 2 \\\n3\n";
      final ObjReader.Result reading = read(text);
      assertEquals(List.of(), reading.problems());
      assertArrayEquals(new double[] {1.25, 2.25, 3.25, 4, 5, 6, 7, 8, 10}, reading.mesh().flat().coordinates());
      assertArrayEquals(new int[] {0, 1, 2}, reading.mesh().flat().corners());
    }
  }

  @Test
  void linesAreCountedThroughLargeFiles() {
    assertProblems("# line\n".repeat(100_000) + "  v 1 2 x\n", "100001:9: not a number: found `x`, expected a "
        + "coordinate such as 2.5");
  }

  @Test
  void aNumberOfTooManyDigitsIsNotCutInTwo() {
    final String number = "0".repeat(700) + "1";
    for (int padding = 64_000; padding < 66_000; padding += 50) {
      final ObjReader.Result reading = read("#" + "x".repeat(padding) + "\nv 1 " + number
          + " 2\nv 1 2 3\nv 0 0 1\nf 1 2 3\n"
          + "# more\n".repeat(10_000));
      if (reading.mesh() == null) {
        assertProblems(reading, "2:5: not a number: found `" + "0".repeat(37) + "...`, expected a coordinate such as 2.5");
      } else {
        assertArrayEquals(new double[] {1, 1, 2, 1, 2, 3, 0, 0, 1}, reading.mesh().flat().coordinates());
      }
    }
  }

  /** A naive reader is the oracle: lines and words by the JDK's own means. */
  @Test
  void agreesWithANaiveReader() {
    Trials.of(300, random -> {
      final StringBuilder text = new StringBuilder();
      final StringBuilder expected = new StringBuilder();
      int vertices = 0;
      for (int i = 0; i < 400; i++) {
        if (vertices < 3 || random.nextBoolean()) {
          final float[] p = {random.nextFloat() - 0.5f, (float) random.nextGaussian() * 1e5f, random.nextInt(9)};
          text.append("v ").append(p[0]).append(blank(random)).append(p[1]).append(' ').append(p[2]).append('\n');
          expected.append(p[0]).append(' ').append(p[1]).append(' ').append(p[2]).append('\n');
          vertices++;
        } else {
          final int a = random.nextInt(vertices), b = (a + 1) % vertices, c = (a + 2) % vertices;
          text.append("f ").append(a + 1).append("/7 ").append(b - vertices).append(blank(random)).append(c
              + 1).append("//3\n");
          expected.append(a).append(' ').append(b).append(' ').append(c).append('\n');
        }
      }
      final MeshData mesh = read(text.append("f 1 2 3").toString()).mesh().flat();
      assertEquals(sorted(expected.append("0 1 2\n").toString()), sorted(described(mesh)));
    });
  }

  private static String blank(final Random random) {
    return new String[] {" ", "\t", "  ", " \\\n", " \\\r\n\t"}[random.nextInt(5)];
  }

  private static String described(final MeshData mesh) {
    final StringBuilder text = new StringBuilder();
    for (int i = 0; i < mesh.coordinates().length; i += 3) {
      text.append((float) mesh.coordinates()[i]).append(' ').append((float) mesh.coordinates()[i
          + 1]).append(' ').append((float) mesh.coordinates()[i + 2]).append('\n');
    }
    for (int i = 0; i < mesh.corners().length; i += 3) {
      text.append(mesh.corners()[i]).append(' ').append(mesh.corners()[i + 1]).append(' ').append(mesh.corners()[i
          + 2]).append('\n');
    }
    return text.toString();
  }

  private static List<String> sorted(final String text) {
    return text.lines().sorted().collect(Collectors.toList());
  }

  private static byte[] zip(final String... namesAndTexts) throws IOException {
    final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      for (int i = 0; i < namesAndTexts.length; i += 2) {
        zip.putNextEntry(new ZipEntry(namesAndTexts[i]));
        zip.write(namesAndTexts[i + 1].getBytes(StandardCharsets.UTF_8));
      }
    }
    return bytes.toByteArray();
  }

  @Test
  void theFirstEntryOfAZipFileIsTheMesh() throws IOException {
    final ObjReader.Result reading = read(zip("folder/", "", "folder/a.obj", SQUARE
        + "f 1 2 3 4\n", "__MACOSX/a.obj", "v x"));
    assertEquals(List.of(), reading.problems());
    assertEquals(6, reading.mesh().flat().corners().length);
    assertProblems(read(zip("folder/", "")), "1:1: the ZIP file is empty: expected an OBJ file as its first entry");
  }

  @Test
  void aBrokenZipFileIsTold() throws IOException {
    final byte[] whole = zip("a.obj", (SQUARE + "f 1 2 3 4\n").repeat(1000));
    for (int length = 4; length < 200; length += 3) {
      final ObjReader.Result reading = read(Arrays.copyOf(whole, length));
      assertNull(reading.mesh());
      assertEquals(1, reading.problems().size());
    }
  }

  @Test
  void aZipBombStopsAtItsLimit() throws IOException {
    final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      zip.putNextEntry(new ZipEntry("bomb.obj"));
      final byte[] blanks = new byte[1 << 20];
      Arrays.fill(blanks, (byte) ' ');
      for (int i = 0; i <= 1024; i++) {
        zip.write(blanks);
      }
    }
    final ThreadMXBean clock = ManagementFactory.getThreadMXBean();
    final long start = clock.getCurrentThreadCpuTime();
    assertProblems(read(bytes.toByteArray()), "1:1: the first entry of the ZIP file is longer than 1 GB: unpack it "
        + "and name the OBJ file");
    assertTrue(clock.getCurrentThreadCpuTime() - start < 15e9);
  }
}
