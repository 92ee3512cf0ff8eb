package meshes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import materials.Texture;
import models.TriangularMesh;
import primitives.Point3D;
import primitives.Vector3D;
import scenes.SceneFiles;
import tracer.Hit;
import tracer.Ray;
import trials.Trials;

class ObjFileTest {

  private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nvt 0.5 0.5\nf 1/1/1 2/1/1 3/1/1\n";

  @TempDir
  Path folder;

  private SceneFiles files;

  @BeforeEach
  void start() {
    files = new SceneFiles(folder);
  }

  private static Hit hit(final TriangularMesh mesh) {
    return mesh.intersectionWith(new Ray(new Point3D(0.25f, 0.25f, 5), new Vector3D(0, 0, -1)));
  }

  @Test
  void aMeshIsReadInOneLine() {
    final TriangularMesh mesh = ObjFile.read(files.write("a.obj", TRIANGLE), Color.PINK);
    assertEquals(Color.PINK, mesh.getColor());
    assertEquals(5, hit(mesh).getT());
    assertEquals(new Vector3D(0.6f, 0, 0.8f), hit(mesh).getNormal());
    assertEquals(new Vector3D(0, 0, 1), hit(mesh).getGeometricNormal());
  }

  /** Polygons in another order, their corners rotated, so that they are cut differently: the averages are the same. */
  @Test
  void averagesOfPolygonsDoNotDependOnTheirOrder() {
    Trials.of(20, random -> {
      final StringBuilder vertices = new StringBuilder();
      final List<String> facets = new ArrayList<>();
      for (int i = 0; i < 25; i++) {
        vertices.append("v ").append(i % 5).append(' ').append(i / 5).append(' ').append(random.nextDouble()).append('\n');
        if (i % 5 < 4 && i < 20) {
          facets.add((i + 1) + " " + (i + 2) + " " + (i + 7) + " " + (i + 6));
        }
      }
      final TriangularMesh mesh = ObjFile.read(files.write("a.obj", vertices + lines(facets)), Color.PINK);
      for (int i = 0; i < facets.size(); i++) {
        final List<String> corners = new ArrayList<>(List.of(facets.get(i).split(" ")));
        Collections.rotate(corners, random.nextInt(4));
        facets.set(i, String.join(" ", corners));
      }
      Collections.shuffle(facets, random);
      final TriangularMesh other = ObjFile.read(files.write("a.obj", vertices + lines(facets)), Color.PINK);
      for (int i = 0; i < 25; i++) {
        final Ray ray = new Ray(new Point3D(i % 5, i / 5, 5), new Vector3D(0, 0, -1));
        final Hit hit = mesh.intersectionWith(ray), same = other.intersectionWith(ray);
        assertEquals(hit.normalX(), same.normalX(), 1e-12);
        assertEquals(hit.normalY(), same.normalY(), 1e-12);
        assertEquals(hit.normalZ(), same.normalZ(), 1e-12);
      }
    });
  }

  private static String lines(final List<String> facets) {
    return facets.stream().map(facet -> "f " + facet + "\n").collect(Collectors.joining());
  }

  @Test
  void aCoordinateThatNoFloatHoldsIsAnErrorWhereNothingIsPlaced() {
    final Path file = files.write("a.obj", TRIANGLE + "v 0 -1e39 0\nv 0 0 1e40\n");
    final String message = assertThrows(ObjFile.InvalidException.class, () -> ObjFile.read(file, Color.PINK)).getMessage();
    assertTrue(message.startsWith(file + ":") && message.endsWith(":5: the coordinate `-1e39` is too large: "
        + "expected at most 3.4e38 in absolute value"), message);
  }

  @Test
  void aTextureColoursIt() {
    final BufferedImage image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
    image.setRGB(1, 0, 0x123456);
    final TriangularMesh mesh = ObjFile.read(files.write("a.obj", TRIANGLE), new Texture(image));
    assertEquals(new Color(0x123456), hit(mesh).getObject().getColorAt(hit(mesh)));
    assertEquals(new Texture(image).getMeanColor(), mesh.getColor());
  }

  @Test
  void materialFilesColourIt() {
    files.write("m.mtl", "newmtl red\nKd 1 0 0\n");
    final TriangularMesh mesh = ObjFile.read(files.write("a.obj", "mtllib m.mtl\n" + TRIANGLE.replace("f ", "usemtl red\nf ")
        + "f 1 2 3\nusemtl none\nf 2 1 3\n"));
    assertNull(mesh.getColor());
    assertEquals(Color.RED, mesh.getTriangles().get(0).getColor());
    assertEquals(Color.RED, mesh.getTriangles().get(1).getColor());
    assertEquals(new Color(204, 204, 204), mesh.getTriangles().get(2).getColor());
  }

  @Test
  void errorsNameFileLineAndColumn() {
    final Path file = files.write("a.obj", "v 0 0 x\nf 1 2 3\n");
    final UncheckedIOException invalid = assertThrows(UncheckedIOException.class, () -> ObjFile.read(file, Color.PINK));
    assertTrue(invalid.getMessage().startsWith(file + ":1:7: not a number: found `x`"), invalid.getMessage());
    assertEquals(2, invalid.getMessage().lines().count());
  }

  @Test
  void aFileThatIsMissingIsNamedAndASimilarOneSuggested() {
    files.write("Cow.obj", TRIANGLE);
    final Path file = folder.resolve("cow.obj");
    assertEquals(file + ": there is no such file. Did you mean `" + folder.resolve("Cow.obj") + "`?",
        assertThrows(ObjFile.InvalidException.class, () -> ObjFile.read(file, Color.PINK)).getMessage());
  }
}
