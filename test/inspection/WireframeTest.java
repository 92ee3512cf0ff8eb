package inspection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;

import org.junit.jupiter.api.Test;

import models.Object3D;
import models.Plane;
import models.Sphere;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import view.FishEye;
import scenes.SceneFile;
import scenes.SceneReader;
import tracer.Hit;
import tracer.Ray;
import view.Angular;
import view.Orthographic;

class WireframeTest {

  private static long count(final List<Wireframe.Line> lines, final Wireframe.Kind kind) {
    return lines.stream().filter(line -> line.kind() == kind).count();
  }

  private static Wireframe.Line first(final List<Wireframe.Line> lines, final Wireframe.Kind kind) {
    return lines.stream().filter(line -> line.kind() == kind).findFirst().orElseThrow();
  }

  @Test
  void boxesHaveTwelveEdgesAndThoseWithoutEndNone() {
    final SceneFile scene = SampleScenes.of(SampleScenes.perspective(), true, new Sphere(new Point3D(), 1, Color.RED),
        new Sphere(new Point3D(3, 0, 0), 1, Color.BLUE), new Plane(new Point3D(), new Vector3D(0, 1, 0), Color.GRAY));
    final List<Wireframe.Line> lines = Wireframe.of(scene, 640, 480);
    assertEquals(24, count(lines, Wireframe.Kind.BOX));
    assertEquals(Color.RED.getRGB(), first(lines, Wireframe.Kind.BOX).argb());
    assertEquals(0, count(lines, Wireframe.Kind.RAY));
    assertEquals(4, count(lines, Wireframe.Kind.PLANE));
    lines.stream().filter(line -> line.kind() == Wireframe.Kind.PLANE).forEach(line -> assertEquals(0, line.from().y,
        1e-6f));
  }

  @Test
  void theWindowOfAPerspectiveLiesOneBeforeTheCamera() {
    final SceneFile scene = SampleScenes.of(SampleScenes.perspective(), true);
    final List<Wireframe.Line> lines = Wireframe.of(scene, 640, 480);
    assertEquals(4, count(lines, Wireframe.Kind.WINDOW));
    assertEquals(4, first(lines, Wireframe.Kind.WINDOW).from().z, 1e-6f);
    assertEquals(-Math.tan(Math.toRadians(22.5)), first(lines, Wireframe.Kind.WINDOW).from().y, 1e-6);
  }

  @Test
  void theWindowOfAParallelProjectionStandsWhereTheCameraIs() {
    final List<Wireframe.Line> lines = Wireframe.of(SampleScenes.of(new Orthographic(4, 1), true), 8, 8);
    assertEquals(5, first(lines, Wireframe.Kind.WINDOW).from().z, 1e-6f);
    assertEquals(7 + 7, count(lines, Wireframe.Kind.GRID));
  }

  /** The rim of the cap ends the view, and the cap is round about the camera, with its window where the rim is. */
  private static void assertCap(final SceneFile scene, final double degrees, final double radius) {
    final Point3D eye = scene.camera().getPosition();
    final Vector3D look = scene.camera().getLook();
    final Function<Point3D, Vector3D> seen = point -> new Vector3D(point.x - eye.x, point.y - eye.y, point.z - eye.z);
    final List<Wireframe.Line> lines = Wireframe.of(scene, 64, 64);
    final List<Wireframe.Line> sight = lines.stream().filter(line -> line.kind() == Wireframe.Kind.FRUSTUM).toList();
    assertEquals(4, sight.size());
    sight.forEach(line -> assertEquals(degrees / 2, Math.toDegrees(look.angle(seen.apply(line.to()))), 1e-3));
    final List<Wireframe.Line> window = lines.stream().filter(line -> line.kind() == Wireframe.Kind.WINDOW).toList();
    final double depth = radius * Math.cos(Math.toRadians(degrees / 2));
    window.subList(0, 4).forEach(side -> assertEquals(depth, look.dot(seen.apply(side.from())), 1e-5));
    for (final Wireframe.Line line : window.subList(4, window.size())) {
      assertEquals(radius, seen.apply(line.to()).length(), 1e-5);
      assertTrue(look.dot(seen.apply(line.to())) > depth - 1e-5);
    }
  }

  @Test
  void theCapOfAFishEyeIsDrawnWhereItsRaysGo() {
    assertCap(SceneReader.read(Path.of("scenes", "angular.xml")).scene().orElseThrow(), 180, 1);
    assertCap(SampleScenes.of(new FishEye(100), true), 100, 1);
    assertCap(SampleScenes.of(new Angular(100), true), 100, 1 / Math.cos(Math.toRadians(50)));
  }

  @Test
  void theGridOfAFineRasterIsThinnedOut() {
    final List<Wireframe.Line> lines = Wireframe.of(SampleScenes.of(new Angular(90), true), 1000, 1000);
    assertEquals(2 * 15, count(lines, Wireframe.Kind.GRID));
  }

  @Test
  void aSkyAroundTheCameraDoesNotMakeTheRestSmall() {
    final Sphere sky = new Sphere(new Point3D(), 1000, Color.BLUE), ball = new Sphere(new Point3D(), 1, Color.RED);
    final List<Wireframe.Line> lines = Wireframe.of(SampleScenes.of(SampleScenes.perspective(), true, sky, ball), 8, 8);
    assertEquals(12, count(lines, Wireframe.Kind.AROUND));
    assertTrue(Wireframe.bounds(lines).maxX() < 10);
    final List<Wireframe.Line> alone = Wireframe.of(SampleScenes.of(SampleScenes.perspective(), true, sky), 8, 8);
    assertTrue(Wireframe.bounds(alone).maxX() >= 1000);
  }

  @Test
  void anObjectThatCannotTellItsBoxIsLeftOut() {
    final Object3D secret = new Object3D(Color.RED) {
      @Override
      public Hit intersectionWith(final Ray ray) {
        return Hit.NOHIT;
      }

      @Override
      public BoundingBox getBoundingBox() {
        throw new IllegalStateException("no box");
      }
    };
    assertEquals(0, count(Wireframe.of(SampleScenes.of(SampleScenes.perspective(), true, secret), 8, 8),
        Wireframe.Kind.BOX));
  }

  @Test
  void theRayEndsAtItsHit() {
    final Sphere sphere = new Sphere(new Point3D(), 1, Color.RED);
    final SceneFile scene = SampleScenes.of(new Orthographic(4, 1), true, sphere);
    final Ray ray = new Ray(new Point3D(0, 0, 5), new Vector3D(0, 0, -1));
    final List<Wireframe.Line> lines = Wireframe.of(scene, 8, 8, ray, sphere.intersectionWith(ray));
    assertEquals(new Point3D(0, 0, 1), first(lines, Wireframe.Kind.RAY).to());
    assertEquals(1, count(lines, Wireframe.Kind.NORMAL));
    assertEquals(0, count(Wireframe.of(scene, 8, 8, ray, Hit.NOHIT), Wireframe.Kind.NORMAL));
  }
}
