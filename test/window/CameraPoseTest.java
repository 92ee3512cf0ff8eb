package window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;

import primitives.Point3D;
import primitives.Vector3D;
import scenes.CameraText;
import view.Camera;
import view.FishEye;
import view.Orthographic;
import view.Perspective;
import view.Projection;

class CameraPoseTest {

  private static final long SEED = 1504;

  private static CameraPose pose(final Random random, final Projection projection) {
    final Camera camera = new Camera(new Point3D(random.nextFloat() * 8 - 4, random.nextFloat() * 8 - 4, 6),
        new Point3D(random.nextFloat(), random.nextFloat(), 0), new Vector3D(0.1f, 3, -0.2f));
    camera.setProjection(projection);
    return CameraPose.of(camera);
  }

  @Test
  void aCameraThatWasNotMovedIsTheSame() {
    final CameraPose pose = pose(new Random(SEED), new Perspective(40, 1.5f));
    final Camera camera = new Camera(new Point3D(0.1f, 1 / 3f, 5e6f), new Point3D(0.7f, 0, 0), new Vector3D(0, 1, 0));
    camera.setProjection(pose.projection());
    assertEquals(CameraText.of(camera), CameraText.of(CameraPose.of(camera).camera()));
    assertSame(camera.getProjection(), CameraPose.of(camera).camera().getProjection());
  }

  @Test
  void turningKeepsTheDistanceAndReturns() {
    final Random random = new Random(SEED);
    for (int i = 0; i < 500; i++) {
      final CameraPose pose = pose(random, new Perspective(40, 1));
      final double across = random.nextDouble() * 2 - 1, upwards = random.nextDouble() * 0.4 - 0.2;
      final CameraPose turned = pose.turned(across, upwards);
      assertEquals(pose.V().distance(pose.C()), turned.V().distance(turned.C()), 1e-9, "seed " + SEED);
      assertEquals(pose.C(), turned.C());
      assertEquals(0, pose.V().distance(turned.turned(-across, -upwards).V()), 1e-9, "seed " + SEED);
    }
  }

  @Test
  void turningStopsBeforeThePoles() {
    CameraPose pose = pose(new Random(SEED), new Perspective(40, 1));
    for (int i = 0; i < 100; i++) {
      pose = pose.turned(0.1, 0.2);
      assertTrue(pose.camera().getLook().length() > 0.99);
    }
    assertTrue(pose.camera().getLook().angle(pose.camera().getUp()) > 3.1);
  }

  /** Turned to the right by a small angle, the camera stands to the right of where it was. */
  @Test
  void turningAndMovingGoToTheSidesOfThePicture() {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Orthographic(4, 1));
    final CameraPose pose = CameraPose.of(camera);
    assertTrue(pose.turned(0.1, 0).V().x > 0.4);
    assertTrue(pose.turned(0, 0.1).V().y > 0.4);
    assertEquals(4, pose.moved(1, 0).C().x, 1e-9);
    assertEquals(4, pose.moved(0, 1).V().y, 1e-9);
    assertEquals(2.5, pose.atDistance(0.5).V().z, 1e-9);
  }

  @Test
  void movingFarAndNearGivesNumbersThatAPersonWouldWrite() {
    final CameraPose pose = pose(new Random(SEED), new Perspective(40, 1)).turned(0.123, 0.045).moved(0.1, 0.2);
    for (final String number : CameraText.of(pose.camera()).position()) {
      assertTrue(number.length() <= 8, number);
    }
  }

  @Test
  void projectionsShowAboutTheSamePart() {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(40, 1.5f));
    final CameraPose pose = CameraPose.of(camera);
    final Projection parallel = pose.withProjection(CameraPose.Optics.ORTHOGRAPHIC, 1.5).projection();
    assertEquals(10 * Math.tan(Math.toRadians(20)), parallel.getHeight(), 1e-5);
    assertEquals(1.5, parallel.getWidth() / parallel.getHeight(), 1e-6);
    final CameraPose back = pose.withProjection(CameraPose.Optics.ORTHOGRAPHIC, 1.5)
        .withProjection(CameraPose.Optics.PERSPECTIVE, 1.5);
    assertEquals(camera.getProjection().getHeight(), back.projection().getHeight(), 1e-5);
    assertTrue(pose.withProjection(CameraPose.Optics.FISH_EYE, 1.5).projection() instanceof FishEye);
    assertTrue(pose.widened(1.1).projection().getHeight() > camera.getProjection().getHeight());
    CameraPose wide = pose;
    for (int i = 0; i < 100; i++) {
      wide = wide.widened(1.5);
    }
    assertTrue(wide.projection().getHeight() < 50);
  }
}
