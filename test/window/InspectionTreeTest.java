package window;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Enumeration;
import java.util.List;
import java.util.Map;

import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.TreeNode;
import javax.vecmath.TexCoord2f;
import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import inspection.Inspector;
import inspection.SampleScenes;
import materials.Texture;
import models.AffineTransformation;
import models.Object3D;
import models.Sphere;
import models.TriangularMesh;
import primitives.Point3D;
import scenes.SceneFile;
import view.Orthographic;

class InspectionTreeTest {

  /** Four texels: red and green above, blue and white below. */
  private static Texture texture() {
    final BufferedImage image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
    image.setRGB(0, 0, 2, 2, new int[] {0xff0000, 0x00ff00, 0x0000ff, 0xffffff}, 0, 2);
    return new Texture(image);
  }

  /** The lines of the pixel in the middle of a picture of 3 by 3. */
  private static String lines(final Object3D object, final Samples samples) {
    final SceneFile scene = SampleScenes.of(new Orthographic(3, 1), true, object);
    final DefaultMutableTreeNode root = InspectionTree.of(new Inspector(scene, 3, 3).inspect(1, 1), scene.names(), samples);
    final StringBuilder lines = new StringBuilder();
    for (final Enumeration<TreeNode> nodes = root.preorderEnumeration(); nodes.hasMoreElements();) {
      lines.append(nodes.nextElement()).append('\n');
    }
    return lines.toString();
  }

  private static TriangularMesh mesh() {
    final Map<Integer, Point3D> vertices = Map.of(1, new Point3D(-1, -1, 0), 2, new Point3D(1, -1, 0), 3,
        new Point3D(0, 1, 0));
    final Map<Integer, TexCoord2f> uv = Map.of(1, new TexCoord2f(0, 0), 2, new TexCoord2f(1, 0), 3, new TexCoord2f(0.7f, 1));
    return new TriangularMesh(vertices, Map.of(), uv, List.of("1/1 2/2 3/3"), texture());
  }

  /** The ray through the origin hits the middle between C and the middle of AB. */
  @Test
  void aMeshShowsTheTriangleItsWeightsAndTheTexel() {
    for (final Object3D object : List.of(mesh(), new AffineTransformation(new Vector3f(2, 2, 1), new Vector3f(0, 0, 1), 0,
        new Vector3f(), mesh()))) {
      final String lines = lines(object, Samples.ONE);
      assertTrue(lines.contains("weights of the corners A, B, C: 0.25, 0.25, 0.5\n"), lines);
      assertTrue(lines.contains("Triangle(A=(-1.0, -1.0, 0.0)"), lines);
      assertTrue(lines.contains("texel in column 1, row 0 from the top of 2 x 2: 0 255 0\n"), lines);
    }
  }

  @Test
  void aBallShowsItsTexel() {
    final String lines = lines(new Sphere(new Point3D(0.1f, 0.1f, 0), 1, texture()), Samples.ONE);
    assertTrue(lines.contains("texel in column 0, row 1 from the top of 2 x 2: 0 0 255\n"), lines);
    assertFalse(lines.contains("weights"), lines);
  }

  @Test
  void samplesOfThePictureAreMentioned() {
    final Sphere ball = new Sphere(new Point3D(), 1, Color.RED);
    assertFalse(lines(ball, Samples.ONE).contains("samples of the picture"));
    assertTrue(lines(ball, new Samples(4, true)).contains("samples of the picture: 4 x 4 at edges\n"));
  }
}
