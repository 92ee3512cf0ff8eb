package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;

import javax.vecmath.Vector3f;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import upnatray.Image;
import view.Angular;
import view.Camera;
import view.Orthographic;
import view.Perspective;
import view.Projection;

/**
 * Closed meshes in pictures, where rays are traced in tiles: no pixel between triangles, and the same colours as by
 * single rays.
 */
class MeshPictureTest {

  private static final Color BACKGROUND = new Color(255, 0, 255, 77);

  static List<ClosedMesh> meshes() {
    return List.of(ClosedMesh.tetrahedron(), ClosedMesh.cube(), ClosedMesh.octahedron(), ClosedMesh.icosphere(5),
        ClosedMesh.cube().shaken(new RandomNumbers("shaken cube"), 0.2),
        ClosedMesh.icosphere(3).moved(1, 3000, -5000, 8000), ClosedMesh.icosphere(2).moved(1e5f, 0, 0, 0));
  }

  private static TriangularMesh colourful(final ClosedMesh mesh) {
    return TriangularMesh.of(mesh.coordinates(), mesh.corners(), null);
  }

  private static Point3D middle(final Object3D mesh) {
    final Point3D middle = new Point3D();
    middle.interpolate(mesh.getBoundingBox().getMin(), mesh.getBoundingBox().getMax(), 0.5f);
    return middle;
  }

  private static void assertPicture(final Object3D object, final Camera camera, final Projection projection,
      final int W, final int H, final boolean closed) {
    camera.setProjection(projection);
    final Group3D scene = new Group3D();
    scene.addObject(object);
    final Image image = new Image(W, H, BACKGROUND);
    image.synthesis(scene, camera);
    final RayGenerator rays = camera.getRayGenerator(W, H);
    for (int n = 0; n < H; n++) {
      for (int m = 0; m < W; m++) {
        final Ray ray = rays.getRay(m, n);
        final Hit hit = object.intersectionWith(ray);
        final int pixel = image.getRGB(m, H - 1 - n);
        final String what = object + ", " + projection.getClass() + ", " + ray + ": " + hit;
        assertEquals(hit.hits() ? hit.getObject().getColor().getRGB() : BACKGROUND.getRGB(), pixel, what);
        assertTrue(!closed || hit.hits() || ray == Ray.NORAY, what);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("meshes")
  void noPixelShowsTheBackgroundFromInside(final ClosedMesh closed) {
    final TriangularMesh mesh = colourful(closed);
    final Point3D middle = middle(mesh);
    final float size = mesh.getBoundingBox().maxX() - mesh.getBoundingBox().minX();
    final Point3D off = new Point3D(middle.x + 0.05f * size, middle.y - 0.03f * size, middle.z + 0.01f * size);
    for (final Vector3D look : List.of(new Vector3D(0, 0, -1), new Vector3D(1, 1, 1), new Vector3D(0.3f, -0.8f, 0.1f))) {
      for (final Point3D eye : List.of(middle, off)) {
        final Point3D at = new Point3D(eye.x + size * look.x, eye.y + size * look.y, eye.z + size * look.z);
        final Camera camera = new Camera(eye, at, new Vector3D(0.1f, 1, 0));
        assertPicture(mesh, camera, new Perspective(100, 1.5f), 63, 41, true);
        assertPicture(mesh, camera, new Angular(179), 37, 37, true);
        assertPicture(mesh, camera, new Orthographic(0.2f * size, 1), 33, 33, true);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("meshes")
  void pictureFromOutsideIsWhatRaysAloneFind(final ClosedMesh closed) {
    final TriangularMesh mesh = colourful(closed);
    final Point3D middle = middle(mesh);
    final float size = mesh.getBoundingBox().maxX() - mesh.getBoundingBox().minX();
    final Camera camera = new Camera(new Point3D(middle.x, middle.y, middle.z + 1.5f * size), middle, new Vector3D(0, 1, 0));
    assertPicture(mesh, camera, new Perspective(45, 1), 65, 65, false);
    assertPicture(mesh, camera, new Orthographic(1.2f * size, 1), 65, 65, false);
    assertPicture(mesh, camera, new Angular(120), 65, 65, false);
  }

  @ParameterizedTest
  @MethodSource("meshes")
  void transformedMeshHasNoCracksEither(final ClosedMesh closed) {
    final TriangularMesh mesh = colourful(closed);
    final float size = mesh.getBoundingBox().maxX() - mesh.getBoundingBox().minX();
    final Object3D transformed = new AffineTransformation(new Vector3f(3 / size, 1 / size, -2 / size),
        new Vector3f(1, 2, 3), 50, new Vector3f(5, 6, 7), mesh);
    final Camera camera = new Camera(middle(transformed), new Point3D(5, 6, 1000), new Vector3D(0.1f, 1, 0));
    assertPicture(transformed, camera, new Perspective(100, 1.5f), 63, 41, true);
    assertPicture(transformed, camera, new Angular(179), 37, 37, true);
    assertPicture(transformed, camera, new Angular(20), 37, 37, true);
    assertPicture(transformed, camera, new Orthographic(0.02f, 1), 16, 16, true);
  }
}
