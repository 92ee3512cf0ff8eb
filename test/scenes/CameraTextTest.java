package scenes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import primitives.Point3D;
import primitives.Vector3D;
import view.Camera;

class CameraTextTest {

  private static final CameraText MOVED =
      CameraText.of(new Camera(new Point3D(1.5f, -2, 30), new Point3D(0, 0.25f, 0), new Vector3D(0, 1, 0)));

  @TempDir
  Path folder;

  private Path file(final String text, final Charset charset) throws IOException {
    return Files.write(folder.resolve("scene.xml"), text.getBytes(charset));
  }

  private static String xml(final String camera) {
    return "<image>\r\n\t<!-- <camera><position>9 9 9</position></camera> -->\r\n" + camera + "\n<scene/></image>\r";
  }

  @Test
  void onlyTheNumbersChange() throws IOException {
    final Path file = file(xml("<camera a='>'><lookAt> 0,\t0 0</lookAt><up>0 1.0  0 </up><position >\n 1\t2\r\n3<!-- m -->"
        + "</position></camera>").replace("0,", "0"), StandardCharsets.UTF_8);
    final String before = Files.readString(file);
    final CameraText replaced = MOVED.writeTo(file);
    assertEquals(xml("<camera a='>'><lookAt> 0\t0.25 0</lookAt><up>0 1.0  0 </up><position >\n 1.5\t-2\r\n30<!-- m -->"
        + "</position></camera>"), Files.readString(file));
    assertEquals(List.of("1", "2", "3"), replaced.position());
    replaced.writeTo(file);
    assertEquals(before, Files.readString(file));
  }

  @Test
  void commentsAndSectionsBetweenTheNumbersStay() throws IOException {
    final Path file = file(xml("<camera><position>1<!-- x -->2 <?p?> 3</position><lookAt><![CDATA[0 0 0]]></lookAt>"
        + "<up>0 1 0</up></camera>"), StandardCharsets.UTF_8);
    MOVED.writeTo(file);
    assertEquals(xml("<camera><position>1.5<!-- x -->-2 <?p?> 30</position><lookAt><![CDATA[0 0.25 0]]></lookAt>"
        + "<up>0 1 0</up></camera>"), Files.readString(file));
  }

  @Test
  void everyEncodingIsKept() throws IOException {
    final String camera = "<camera><position>1 2 3</position><lookAt>0 0 0</lookAt><up>0 1 0</up></camera><!-- \u00f1 -->";
    final String latin = "<?xml version='1.0' encoding='ISO-8859-1'?>" + xml(camera);
    for (final Object[] kind : new Object[][] {{xml(camera), StandardCharsets.UTF_8}, {latin, StandardCharsets.ISO_8859_1},
        {xml(camera), StandardCharsets.ISO_8859_1}, {"\ufeff" + xml(camera), StandardCharsets.UTF_8},
        {"\ufeff" + xml(camera), StandardCharsets.UTF_16LE}, {"\ufeff" + xml(camera), StandardCharsets.UTF_16BE},
        {xml(camera), StandardCharsets.UTF_16BE}, {"\ufeff" + xml(camera), Charset.forName("UTF-32LE")},
        {xml(camera), Charset.forName("UTF-32BE")}}) {
      final Charset charset = (Charset) kind[1];
      final Path file = file((String) kind[0], charset);
      MOVED.writeTo(file);
      final String expected = ((String) kind[0]).replace("1 2 3", "1.5 -2 30").replace("<lookAt>0 0 0", "<lookAt>0 0.25 0");
      assertArrayEquals(expected.getBytes(charset), Files.readAllBytes(file), charset + ": " + kind[0]);
    }
  }

  @Test
  void everySceneIsReadBackWithTheNewCameraAndRestored() throws IOException {
    try (Stream<Path> scenes = Files.list(Path.of("scenes"))) {
      for (final Path scene : scenes.filter(path -> path.toString().endsWith(".xml")).toList()) {
        final byte[] before = Files.readAllBytes(scene);
        final Path file = Files.write(folder.resolve(scene.getFileName()), before);
        final CameraText replaced = MOVED.writeTo(file);
        final Camera camera = SceneReader.read(file).scene().orElseThrow().camera();
        assertEquals(MOVED, CameraText.of(camera), scene::toString);
        replaced.writeTo(file);
        assertArrayEquals(before, Files.readAllBytes(file), scene::toString);
      }
    }
  }

  @Test
  void aFileWithoutSuchACameraStaysAsItIs() throws IOException {
    final String partial = "<camera><position>1 2</position></camera>";
    for (final String text : new String[] {xml(partial), xml(""), "<image>", "", "<a/>"}) {
      final Path file = file(text, StandardCharsets.UTF_8);
      assertThrows(IOException.class, () -> MOVED.writeTo(file), text);
      assertEquals(text, Files.readString(file));
    }
    assertThrows(IOException.class, () -> MOVED.writeTo(folder.resolve("missing.xml")));
  }

  @Test
  void aLinkStaysALinkAndNoOtherFileIsLeft() throws IOException {
    final Path file = file(xml("<camera><position>1 2 3</position><lookAt>0 0 0</lookAt><up>0 1 0</up></camera>"),
        StandardCharsets.UTF_8);
    final Path link = Files.createSymbolicLink(folder.resolve("link.xml"), file);
    MOVED.writeTo(link);
    assertTrue(Files.isSymbolicLink(link));
    assertTrue(Files.readString(file).contains("1.5 -2 30"));
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(2, files.count());
    }
  }

  @Test
  void theElementIsOfTheLanguage() {
    assertEquals("<camera><position>1.5 -2 30</position><lookAt>0 0.25 0</lookAt><up>0 1 0</up></camera>", MOVED.toXml());
  }
}
