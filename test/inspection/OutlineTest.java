package inspection;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.util.List;

import org.junit.jupiter.api.Test;

import models.Plane;
import models.Sphere;
import primitives.Point3D;
import primitives.Vector3D;
import scenes.Scene;
import tracer.Hit;
import tracer.Ray;
import view.Angular;
import view.Orthographic;

class OutlineTest {

  private static long count(final List<Outline.Line> lines, final Outline.Kind kind) {
    return lines.stream().filter(line -> line.kind() == kind).count();
  }

  private static Outline.Line first(final List<Outline.Line> lines, final Outline.Kind kind) {
    return lines.stream().filter(line -> line.kind() == kind).findFirst().orElseThrow();
  }

  @Test
  void boxesHaveTwelveEdgesAndThoseWithoutEndNone() {
    final Scene scene = SampleScenes.of(SampleScenes.perspective(), true, new Sphere(new Point3D(), 1, Color.RED),
        new Sphere(new Point3D(3, 0, 0), 1, Color.BLUE), new Plane(new Point3D(), new Vector3D(0, 1, 0), Color.GRAY));
    final List<Outline.Line> lines = Outline.of(scene, 640, 480);
    assertEquals(24, count(lines, Outline.Kind.BOX));
    assertEquals(Color.RED.getRGB(), first(lines, Outline.Kind.BOX).argb());
    assertEquals(0, count(lines, Outline.Kind.RAY));
    assertEquals(4, count(lines, Outline.Kind.PLANE));
    lines.stream().filter(line -> line.kind() == Outline.Kind.PLANE).forEach(line -> assertEquals(0, line.from().y, 1e-6f));
  }

  @Test
  void theWindowOfAPerspectiveLiesOneBeforeTheCamera() {
    final Scene scene = SampleScenes.of(SampleScenes.perspective(), true);
    final List<Outline.Line> lines = Outline.of(scene, 640, 480);
    assertEquals(4, count(lines, Outline.Kind.WINDOW));
    assertEquals(4, first(lines, Outline.Kind.WINDOW).from().z, 1e-6f);
    assertEquals(-Math.tan(Math.toRadians(22.5)), first(lines, Outline.Kind.WINDOW).from().y, 1e-6);
  }

  @Test
  void theWindowOfAParallelProjectionStandsWhereTheCameraIs() {
    final List<Outline.Line> lines = Outline.of(SampleScenes.of(new Orthographic(4, 1), true), 8, 8);
    assertEquals(5, first(lines, Outline.Kind.WINDOW).from().z, 1e-6f);
    assertEquals(7 + 7, count(lines, Outline.Kind.GRID));
  }

  @Test
  void theGridOfAFineRasterIsThinnedOut() {
    final List<Outline.Line> lines = Outline.of(SampleScenes.of(new Angular(90), true), 1000, 1000);
    assertEquals(2 * 15, count(lines, Outline.Kind.GRID));
  }

  @Test
  void theRayEndsAtItsHit() {
    final Sphere sphere = new Sphere(new Point3D(), 1, Color.RED);
    final Scene scene = SampleScenes.of(new Orthographic(4, 1), true, sphere);
    final Ray ray = new Ray(new Point3D(0, 0, 5), new Vector3D(0, 0, -1));
    final List<Outline.Line> lines = Outline.of(scene, 8, 8, ray, sphere.intersectionWith(ray));
    assertEquals(new Point3D(0, 0, 1), first(lines, Outline.Kind.RAY).to());
    assertEquals(1, count(lines, Outline.Kind.NORMAL));
    assertEquals(0, count(Outline.of(scene, 8, 8, ray, Hit.NOHIT), Outline.Kind.NORMAL));
  }
}
