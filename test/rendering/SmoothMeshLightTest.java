package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import lights.LightGroup;
import lights.Omnidirectional;
import materials.AshikhminShirley;
import materials.Blinn;
import materials.Lambertian;
import materials.Material;
import models.AffineTransformation;
import models.Group3D;
import models.Object3D;
import models.RandomNumbers;
import models.TriangularMesh;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;
import tracer.Hit;
import tracer.Ray;

/** An open sheet of triangles with any normals at its corners: what lies behind its facets does not light their front. */
class SmoothMeshLightTest {

  private static final SpectrumRGB WHITE = new SpectrumRGB(1f / 3, 1f / 3, 1f / 3);
  private static final int SIDE = 6;

  private static final List<Material> MATERIALS = List.of(new Lambertian(new ReflectanceRGB(1, 1, 1)),
      new AshikhminShirley(new ReflectanceRGB(0.5f, 0.5f, 0.5f), new ReflectanceRGB(0.5f, 0.5f, 0.5f), new Blinn(60)));

  /** Hills over the square from −3 to 3, no steeper than 45°, with normals in every direction. */
  private static TriangularMesh sheet(final RandomNumbers numbers, final Material material) {
    final Map<Integer, Point3D> vertices = new HashMap<>();
    final Map<Integer, Vector3D> normals = new HashMap<>();
    final List<String> facets = new ArrayList<>();
    for (int i = 0; i <= SIDE; i++) {
      for (int j = 0; j <= SIDE; j++) {
        final int at = i * (SIDE + 1) + j;
        vertices.put(at, new Point3D(i - 3, j - 3, (float) numbers.between(0, 0.7)));
        normals.put(at, numbers.direction());
        if (i < SIDE && j < SIDE) {
          final int right = at + SIDE + 1;
          facets.add(corner(at) + corner(right) + corner(right + 1));
          facets.add(corner(at) + corner(right + 1) + corner(at + 1));
        }
      }
    }
    return new TriangularMesh(vertices, normals, facets, material);
  }

  private static String corner(final int vertex) {
    return vertex + "//" + vertex + " ";
  }

  private static double radiance(final Group3D scene, final Ray ray, final Hit hit, final Point3D lamp) {
    return new Illumination(scene, new LightGroup(new Omnidirectional(lamp, WHITE, 1e5f)), 0, Color.BLACK)
        .radiance(ray, hit, LightObserver.NONE).getR();
  }

  /** Lamps far enough below or above to lie behind every facet, seen from its front and, with the lamps, from its back. */
  @Test
  void noLightLeaksThroughAMesh() {
    final RandomNumbers numbers = new RandomNumbers("leaking meshes");
    final int[] lit = {0, 0};
    for (int i = 0; i < RandomNumbers.times(40); i++) {
      final Object3D mesh = sheet(numbers, MATERIALS.get(i % 2));
      final float mirrored = i % 4 < 2 ? 1 : -1;
      final Group3D scene = new Group3D();
      scene.addObject(i % 3 == 0 ? mesh : new AffineTransformation(new Vector3f(mirrored, 1.5f, 0.8f), new Vector3f(0, 0, 1),
          40, new Vector3f(), mesh));
      for (int k = 0; k < 400; k++) {
        final int front = k % 2 == 0 ? 1 : -1;
        final Point3D eye = new Point3D((float) numbers.between(-9, 9), (float) numbers.between(-9, 9), 40f * front);
        final Point3D behind = new Point3D((float) numbers.between(-9, 9), (float) numbers.between(-9, 9), -40f * front);
        final Ray ray = new Ray(eye, new Point3D((float) numbers.between(-2, 2), (float) numbers.between(-2, 2), 0));
        final Hit hit = scene.intersectionWith(ray);
        assertTrue(hit.geometricZ() > 0.3, hit::toString);
        assertEquals(0, radiance(scene, ray, hit, behind), () -> hit + " by " + behind + " along " + ray + "; " + numbers);
        lit[k % 2] += radiance(scene, ray, hit, eye) > 0 ? 1 : 0;
      }
    }
    assertTrue(lit[0] > 2000 && lit[1] > 2000, () -> "too few points are lit: " + lit[0] + ", " + lit[1]);
  }
}
