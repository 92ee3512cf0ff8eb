package upnatray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;

import javax.vecmath.Vector3f;

import models.AffineTransformation;
import models.Group3D;
import models.Object3D;
import models.Sphere;
import org.junit.jupiter.api.Test;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import rendering.RenderSettings;
import tracer.Hit;
import tracer.Ray;
import view.Camera;
import view.Perspective;

/** A user-written shape that changes between two pictures, as in an animation, is shown where it is. */
class MovedShapeTest {

  /** A ball that can be moved. */
  private static final class Moved extends Object3D {

    private float x;

    Moved() {
      super(Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final Hit hit = new Sphere(new Point3D(x, 0, 0), 1, Color.RED).intersectionWith(ray);
      return hit.hits() ? new Hit(hit.getT(), hit.getPoint(), hit.getNormal(), this) : hit;
    }

    @Override
    public BoundingBox getBoundingBox() {
      return new BoundingBox(new Point3D(x - 1, -1, -1), new Point3D(x + 1, 1, 1));
    }
  }

  private static Group3D group(final Object3D... objects) {
    final Group3D group = new Group3D();
    for (final Object3D object : objects) {
      group.addObject(object);
    }
    return group;
  }

  /** Columns of the picture that show something red, the leftmost and the rightmost. */
  private static String columns(final Group3D scene, final RenderSettings settings) {
    final Camera camera = new Camera(new Point3D(0, 0, 10), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(40, 1));
    final Image image = new Image(64, 64, Color.BLACK);
    image.synthesis(scene, camera, settings);
    int first = 64, last = -1;
    for (int i = 0; i < 64 * 64; i++) {
      if (image.getRGB(i % 64, i / 64) == Color.RED.getRGB()) {
        first = Math.min(first, i % 64);
        last = Math.max(last, i % 64);
      }
    }
    return first + " … " + last;
  }

  @Test
  void pictureShowsTheShapeWhereItIsWhenItBegins() {
    final Moved ball = new Moved();
    final Sphere other = new Sphere(new Point3D(0, 3, 0), 0.5f, Color.BLUE);
    final Object3D transformed = new AffineTransformation(new Vector3f(0, 1, 0), 0, new Vector3f(),
        group(other, group(ball)));
    for (final Group3D scene : List.of(group(ball), group(other, group(ball)), group(other, transformed))) {
      for (final RenderSettings settings : List.of(RenderSettings.STANDARD, RenderSettings.STANDARD.withPixelLoop())) {
        ball.x = 0;
        final String before = columns(scene, settings);
        ball.x = 2.5f;
        final String after = columns(scene, settings);
        assertEquals(columns(group(ball), settings), after);
        assertTrue(!after.equals(before) && !after.startsWith("64"), after);
      }
    }
  }

  @Test
  void groupThatIsQueriedDirectlyIsRefreshedOnDemand() {
    final Moved ball = new Moved();
    final Group3D scene = group(new AffineTransformation(new Vector3f(0, 1, 0), 0, new Vector3f(), group(ball)));
    final Ray ray = new Ray(new Point3D(9, 0, 5), new Vector3D(0, 0, -1));
    assertTrue(!scene.intersectionWith(ray).hits());
    ball.x = 9;
    scene.refresh();
    assertTrue(scene.intersectionWith(ray).hits());
  }

  @Test
  void objectAddedToAGroupWithinTransformationsAndGroupsIsSeen() {
    final Group3D innermost = group(), middle = group(innermost);
    final Group3D scene = group(group(new AffineTransformation(new Vector3f(0, 1, 0), 0, new Vector3f(), middle)));
    final Ray ray = new Ray(new Point3D(0, 0, 5), new Vector3D(0, 0, -1));
    assertTrue(!scene.intersectionWith(ray).hits());
    innermost.addObject(new Sphere(new Point3D(), 1, Color.RED));
    assertTrue(scene.intersectionWith(ray).hits());
    assertEquals(4, scene.intersectionWith(ray).getT());
  }
}
