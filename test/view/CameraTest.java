package view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;
import tracer.RayGenerator;
import trials.Trials;

class CameraTest {

  private static final Point3D ORIGIN = new Point3D();
  private static final Vector3D UP = new Vector3D(0, 1, 0);

  @Test
  void aCameraOnTheAxisOfDepthHasTheFrameOfTheScene() {
    final Camera camera = new Camera(new Point3D(0, 0, 5), ORIGIN, UP);
    final Point3D P = new Point3D(1, 2, 3);
    final Vector3D v = new Vector3D(1, 2, 3);
    camera.toSceneCoordinates(P);
    camera.toSceneCoordinates(v);
    assertEquals(new Point3D(1, 2, 8), P);
    assertEquals(new Vector3D(1, 2, 3), v);
    assertEquals(new Vector3D(0, 0, -1), camera.getLook());
  }

  @Test
  void aCameraThatLooksAlongMinusXHasItsRightAlongMinusZ() {
    final Camera camera = new Camera(new Point3D(5, 0, 0), ORIGIN, new Vector3D(7, 2, 0));
    final Point3D P = new Point3D(1, 2, 3);
    final Vector3D v = new Vector3D(1, 2, 3);
    camera.toSceneCoordinates(P);
    camera.toSceneCoordinates(v);
    assertEquals(new Point3D(8, 2, -1), P);
    assertEquals(new Vector3D(3, 2, -1), v);
    assertEquals(new Vector3D(-1, 0, 0), camera.getLook());
  }

  @Test
  void takesPointsAndVectorsToTheScene() {
    Trials.of(1000, random -> {
      final CameraFrame frame = CameraFrame.random(random);
      final Camera camera = new Camera(frame.V, frame.C, frame.up);
      final float a = (float) random.nextGaussian(), b = (float) random.nextGaussian(), c = (float) random.nextGaussian();
      final Point3D P = new Point3D(a, b, c);
      final Vector3D v = new Vector3D(a, b, c), look = camera.getLook();
      camera.toSceneCoordinates(P);
      camera.toSceneCoordinates(v);
      final double[] point = frame.point(a, b, c), vector = frame.vector(a, b, c), ahead = frame.vector(0, 0, -1);
      final double[] expected = {point[0], point[1], point[2], vector[0], vector[1], vector[2],
          ahead[0], ahead[1], ahead[2]};
      final float[] found = {P.x, P.y, P.z, v.x, v.y, v.z, look.x, look.y, look.z};
      for (int i = 0; i < 9; i++) {
        assertEquals(expected[i], found[i], 0x1p-23 * (i < 3 ? frame.size() + 4 : 4), "number " + i);
      }
    });
  }

  @Test
  void seesWhatIsVeryCloseAndWhatIsVeryFar() {
    final Camera close = new Camera(new Point3D(0, 0, Float.MIN_VALUE), ORIGIN, new Vector3D(0, Float.MIN_VALUE, 0));
    assertEquals(new Vector3D(0, 0, -1), close.getLook());
    final float far = Float.MAX_VALUE;
    final Camera wide = new Camera(new Point3D(-far, 0, 0), new Point3D(far, 0, 0), new Vector3D(0, far, 0));
    assertEquals(new Vector3D(1, 0, 0), wide.getLook());
  }

  @Test
  void keepsCopiesOfWhatItIsGiven() {
    final Point3D V = new Point3D(1, 2, 3), C = new Point3D(1, 2, 0);
    final Vector3D up = new Vector3D(0, 2, 0);
    final Camera camera = new Camera(V, C, up);
    assertEquals(new Vector3D(0, 2, 0), up);
    V.set(9, 9, 9);
    C.set(9, 9, 9);
    up.set(9, 9, 9);
    assertEquals(new Point3D(1, 2, 3), camera.getPosition());
    assertEquals(new Point3D(1, 2, 0), camera.getLookAt());
    assertEquals(new Vector3D(0, 2, 0), camera.getUp());
    assertEquals(new Vector3D(0, 0, -1), camera.getLook());
    camera.setProjection(new Perspective(60, 1));
    assertEquals(new Point3D(1, 2, 3), camera.getRayGenerator(1, 1).getRay(0, 0).getStartingPoint());
  }

  @Test
  void handsOutCopies() {
    final Camera camera = new Camera(new Point3D(1, 2, 3), new Point3D(1, 2, 0), UP);
    camera.setProjection(new Orthographic(1, 1));
    final RayGenerator generator = camera.getRayGenerator(1, 1);
    camera.getPosition().set(9, 9, 9);
    camera.getLookAt().set(9, 9, 9);
    camera.getUp().set(9, 9, 9);
    camera.getLook().set(9, 9, 9);
    generator.getRay(0, 0).getDirection().set(9, 9, 9);
    generator.getRay(0, 0).getStartingPoint().set(9, 9, 9);
    final Ray ray = generator.getRay(0, 0);
    assertEquals(new Point3D(1, 2, 3), camera.getPosition());
    assertEquals(new Point3D(1, 2, 0), camera.getLookAt());
    assertEquals(UP, camera.getUp());
    assertEquals(new Vector3D(0, 0, -1), camera.getLook());
    assertEquals(new Point3D(1, 2, 3), ray.getStartingPoint());
    assertEquals(new Vector3D(0, 0, -1), ray.getDirection());
  }

  @Test
  void holdsTheProjectionSetLast() {
    final Camera camera = new Camera(new Point3D(0, 0, 1), ORIGIN, UP);
    final Projection first = new Perspective(50, 1), second = new Angular(50);
    camera.setProjection(first);
    assertSame(first, camera.getProjection());
    camera.setProjection(second);
    assertSame(second, camera.getProjection());
    assertSame(Ray.NORAY, camera.getRayGenerator(9, 9).getRay(0, 0));
  }

  @Test
  void servesStudentsProjections() {
    final Camera camera = new Camera(new Point3D(0, 0, 1), ORIGIN, UP);
    camera.setProjection(new Projection(2, 1) {
      @Override
      public RayGenerator getRayGenerator(final Camera camera, final int W, final int H) {
        return new RayGenerator(camera, W, H) {
          @Override
          public Ray getRay(final int m, final int n) {
            return new Ray(camera.getPosition(), new Vector3D(m + 1, n, -1));
          }
        };
      }
    });
    assertEquals(2, camera.getProjection().getWidth());
    assertEquals(1, camera.getProjection().getHeight());
    assertTrue(Double.isNaN(camera.getProjection().zAt(0, 0)), "the library does not know the rule of its rays");
    assertEquals(new Ray(new Point3D(0, 0, 1), new Vector3D(4, 2, -1)).toString(),
        camera.getRayGenerator(8, 8).getRay(3, 2).toString());
  }

  @Test
  void withoutAProjectionItHasNoRays() {
    final Camera camera = new Camera(new Point3D(0, 0, 1), ORIGIN, UP);
    assertThrows(IllegalStateException.class, camera::getProjection);
    final Exception wrong = assertThrows(IllegalStateException.class, () -> camera.getRayGenerator(4, 4));
    assertTrue(wrong.getMessage().contains("setProjection"), wrong.getMessage());
    assertThrows(IllegalArgumentException.class, () -> camera.setProjection(null));
  }

  @ParameterizedTest
  @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
  void rejectsWhatIsNotFinite(final float bad) {
    final Point3D V = new Point3D(0, 0, 1), P = new Point3D(0, bad, 0);
    final Vector3D v = new Vector3D(0, 0, bad);
    assertNames("V", () -> new Camera(P, V, UP));
    assertNames("C", () -> new Camera(V, P, UP));
    assertNames("up", () -> new Camera(V, ORIGIN, v));
    final Camera camera = new Camera(V, ORIGIN, UP);
    assertNames("P", () -> camera.toSceneCoordinates(P));
    assertNames("v", () -> camera.toSceneCoordinates(v));
  }

  @Test
  void rejectsNull() {
    final Point3D V = new Point3D(0, 0, 1);
    assertNames("V", () -> new Camera(null, ORIGIN, UP));
    assertNames("C", () -> new Camera(V, null, UP));
    assertNames("up", () -> new Camera(V, ORIGIN, null));
    final Camera camera = new Camera(V, ORIGIN, UP);
    assertNames("P", () -> camera.toSceneCoordinates((Point3D) null));
    assertNames("v", () -> camera.toSceneCoordinates((Vector3D) null));
  }

  @Test
  void rejectsAViewThatGivesNoFrame() {
    final Point3D V = new Point3D(3, 2, 1);
    assertNames("C", () -> new Camera(V, new Point3D(3, 2, 1), UP));
    assertNames("up", () -> new Camera(V, ORIGIN, new Vector3D()));
    assertNames("up", () -> new Camera(V, ORIGIN, new Vector3D(3, 2, 1)));
    assertNames("up", () -> new Camera(V, ORIGIN, new Vector3D(-0.3f, -0.2f, -0.1f)));
  }

  private static void assertNames(final String argument, final Runnable call) {
    final Exception wrong = assertThrows(IllegalArgumentException.class, call::run);
    assertTrue(wrong.getMessage().startsWith(argument + " "), wrong.getMessage());
  }
}
