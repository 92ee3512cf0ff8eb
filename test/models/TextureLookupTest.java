package models;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;

import javax.vecmath.TexCoord2f;

import org.junit.jupiter.api.Test;

import materials.Texture;
import primitives.Point3D;
import tracer.Hit;
import tracer.Ray;

/** What a picture's shading is computed from, as the inspector shows it: weights of corners, and texels. */
class TextureLookupTest {

  private static final int WIDTH = 7;
  private static final int HEIGHT = 5;

  private static BufferedImage image() {
    final BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_ARGB);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
      image.setRGB(i % WIDTH, i / WIDTH, 0xff000000 | 0x10307 * i);
    }
    return image;
  }

  private static TriangularMesh mesh() {
    final Map<Integer, Point3D> vertices = Map.of(1, new Point3D(0, 0, 0), 2, new Point3D(4, 0, 1), 3, new Point3D(0, 3, 2));
    final Map<Integer, TexCoord2f> uv = Map.of(1, new TexCoord2f(0, 0), 2, new TexCoord2f(3, 0.5f),
        3, new TexCoord2f(0.25f, 2));
    return new TriangularMesh(vertices, Map.of(), uv, List.of("1/1 2/2 3/3"), new Texture(image()));
  }

  @Test
  void theTexelHasTheColourThatIsPainted() {
    final BufferedImage image = image();
    final Sphere ball = new Sphere(new Point3D(0.5f, -0.5f, 0), 1.5f, new Texture(image));
    final SplittableRandom random = new SplittableRandom(15);
    int hits = 0;
    for (int i = 0; i < 2000; i++) {
      final Ray ray = new Ray(new Point3D(0, 0, 9), new Point3D((float) random.nextDouble(-1, 4),
          (float) random.nextDouble(-2, 3), 0));
      for (final Object3D object : List.of(ball, mesh())) {
        final Hit hit = object.intersectionWith(ray);
        final Optional<TextureLookup> texel = TextureLookup.of(hit);
        assertEquals(hit.hits(), texel.isPresent());
        if (hit.hits()) {
          hits++;
          assertEquals(hit.getObject().getColorAt(hit), new Color(texel.get().argb(), true));
          assertEquals(image.getRGB(texel.get().column(), texel.get().row()), texel.get().argb());
        }
      }
    }
    assertTrue(hits > 500, "hits: " + hits);
  }

  @Test
  void theWeightsAreThoseThatInterpolateTheTextureCoordinates() {
    final TriangularMesh mesh = mesh();
    for (final double[] weights : new double[][] {{0.2, 0.3, 0.5}, {0.6, 0.1, 0.3}, {1.0 / 3, 1.0 / 3, 1.0 / 3}}) {
      final Point3D P = new Point3D((float) (4 * weights[1]), (float) (3 * weights[2]),
          (float) (weights[1] + 2 * weights[2]));
      final Ray ray = new Ray(new Point3D(1, 1, 9), P);
      final Hit hit = mesh.intersectionWith(ray);
      final Weights found = Weights.of(ray, hit).orElseThrow();
      assertArrayEquals(weights, new double[] {found.a(), found.b(), found.c()}, 1e-6);
      assertEquals(3 * found.b() + 0.25 * found.c(), hit.textureU(), 1e-12);
      assertEquals(0.5 * found.b() + 2 * found.c(), hit.textureV(), 1e-12);
    }
  }

  @Test
  void otherHitsHaveNeither() {
    final Ray ray = new Ray(new Point3D(0, 0, 9), new Point3D());
    final Hit hit = new Sphere(new Point3D(), 1, Color.RED).intersectionWith(ray);
    assertEquals(Optional.empty(), TextureLookup.of(hit));
    assertEquals(Optional.empty(), TextureLookup.of(Hit.NOHIT));
    assertEquals(Optional.empty(), Weights.of(ray, hit));
    assertEquals(Optional.empty(), Weights.of(ray, Hit.NOHIT));
    assertThrows(IllegalArgumentException.class, () -> TextureLookup.of(null));
    assertThrows(IllegalArgumentException.class, () -> Weights.of(null, hit));
    assertThrows(IllegalArgumentException.class, () -> Weights.of(ray, null));
  }

  @Test
  void theArgumentsOfATriangleAreThoseOfItsCorners() {
    final TriangularMesh mesh = mesh();
    final List<Object> arguments = FacetArguments.of(mesh, mesh.getTriangles().get(0));
    assertEquals(5, arguments.size());
    assertEquals(Set.of(1, 2, 3), ((Map<?, ?>) arguments.get(1)).keySet());
    assertEquals(new TexCoord2f(0.25f, 2), ((Map<?, ?>) arguments.get(2)).get(3));
    assertEquals(List.of("1/1/1 2/2/2 3/3/3"), arguments.get(3));
    assertEquals(List.of(), FacetArguments.of(mesh, mesh().getTriangles().get(0)));
    assertEquals(List.of(), FacetArguments.of(mesh, null));
    final TriangularMesh flat = TriangularMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2}, Color.RED);
    assertEquals(List.of(), FacetArguments.of(flat, flat.getTriangles().get(0)));
  }
}
