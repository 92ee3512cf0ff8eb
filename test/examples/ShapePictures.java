package examples;

import java.awt.Color;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

import javax.imageio.ImageIO;
import javax.vecmath.Vector3f;

import models.AffineTransformation;
import models.Box;
import models.Capsule;
import models.Cylinder;
import models.Egg;
import models.Ellipsoid;
import models.Group3D;
import models.Object3D;
import models.Plane;
import models.Sphere;
import models.Torus;
import models.Triangle;
import models.TriangularMesh;
import models.TruncatedCone;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import upnatray.Image;
import rendering.RenderSettings;
import view.Camera;
import view.Perspective;

/** Writes the pictures of the shapes that the documentation shows; {@code ant javadoc} calls it. */
public final class ShapePictures {

  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;
  private static final Color NOTHING = new Color(0, 0, 0, 0);
  private static final Color YELLOW = new Color(246, 178, 60);
  private static final Color RED = new Color(222, 84, 72);
  private static final Color BLUE = new Color(70, 110, 190);
  private static final Vector3D X = new Vector3D(1, 0, 0);
  private static final Vector3D Y = new Vector3D(0, 1, 0);
  private static final Vector3D AWAY = new Vector3D(-0.15f, 1, -0.25f);
  private static final Vector3D TILTED = new Vector3D(0.5f, 1, 0.3f);
  private static final Vector3D LIGHT = new Vector3D(-0.48f, 0.6f, 0.64f);
  private static final Point3D O = new Point3D(0, 0, 0);
  private static final Point3D LOW = new Point3D(0, -0.8f, 0);

  private ShapePictures() {
  }

  /** Writes a PNG file for each shape into the folder that is the only argument. */
  public static void main(final String... arguments) throws IOException {
    final Path folder = Files.createDirectories(Path.of(arguments[0]));
    for (final Map.Entry<String, Group3D> shape : shapes().entrySet()) {
      final Image image = picture(shape.getValue());
      final File file = folder.resolve(shape.getKey() + ".png").toFile();
      if (!ImageIO.write(image, "png", file)) {
        throw new IOException("no writer of PNG files");
      }
    }
  }

  private static Image picture(final Group3D scene) {
    final Camera camera = new Camera(new Point3D(2.4f, 2.4f, 6), O, Y);
    camera.setProjection(new Perspective(28, (float) WIDTH / HEIGHT));
    final Image image = new Image(WIDTH, HEIGHT, NOTHING);
    image.synthesis(scene, camera, RenderSettings.STANDARD.withShading(ShapePictures::argb));
    return image;
  }

  /** Lit from the upper left, and never quite dark, so that no side is lost on a white page. */
  private static int argb(final Ray ray, final Hit hit) {
    final double facing = hit.getNormal().dot(ray.getDirection()) > 0 ? -1 : 1;
    final double k = 0.45 + 0.55 * Math.max(0, facing * hit.getNormal().dot(LIGHT));
    final Color color = hit.getObject().getColor();
    return new Color((int) (k * color.getRed()), (int) (k * color.getGreen()), (int) (k * color.getBlue())).getRGB();
  }

  /** By the name of the class, a scene that shows one of its objects, and where it has an axis or a normal, that in blue. */
  static Map<String, Group3D> shapes() {
    final Map<String, Group3D> shapes = new LinkedHashMap<>();
    shapes.put("Sphere", scene(new Sphere(O, 1.2f, YELLOW)));
    shapes.put("Plane", scene(new Plane(LOW, AWAY, YELLOW), arrow(LOW, AWAY, 1.5f)));
    shapes.put("Triangle", scene(triangle(), arrow(new Point3D(0, -0.23f, 0.1f), new Vector3D(0, 0.45f, 1), 1.2f)));
    shapes.put("Box", scene(new Box(O, new Vector3D(1, 0.1f, 0.3f), Y, 1.9f, 1.1f, 1.5f, YELLOW)));
    shapes.put("Cylinder", scene(new Cylinder(O, TILTED, 0.8f, 1.7f, YELLOW), axis(TILTED, 3)));
    shapes.put("Capsule", scene(new Capsule(O, TILTED, 0.6f, 1.3f, YELLOW), axis(TILTED, 3.2f)));
    shapes.put("Torus", scene(new Torus(O, TILTED, 1.1f, 0.35f, YELLOW), axis(TILTED, 2)));
    shapes.put("Ellipsoid", scene(new Ellipsoid(O, new Vector3D(1, 0.3f, 0), Y, 1.5f, 0.9f, 0.6f, YELLOW)));
    shapes.put("Egg", scene(new Egg(O, TILTED, 0.95f, 1.3f, 0.35f, YELLOW), axis(TILTED, 3.2f)));
    shapes.put("TruncatedCone", scene(new TruncatedCone(O, TILTED, 1, 0.45f, 1.7f, YELLOW), axis(TILTED, 3)));
    shapes.put("TriangularMesh", scene(octahedron()));
    shapes.put("Group3D", scene(new Sphere(new Point3D(-0.9f, 0.2f, 0), 0.7f, YELLOW),
        new Box(new Point3D(0.8f, -0.1f, -0.4f), X, Y, 0.9f, 1.4f, 0.9f, RED),
        new Torus(new Point3D(0, -0.75f, 0.2f), Y, 1.5f, 0.12f, BLUE)));
    shapes.put("AffineTransformation", scene(new AffineTransformation(new Vector3f(1.4f, 0.5f, 0.9f), new Vector3f(1, 0, -1),
        50, new Vector3f(0, 0, 0), new Torus(O, Y, 0.9f, 0.35f, YELLOW))));
    return shapes;
  }

  private static Group3D scene(final Object3D... objects) {
    final Group3D scene = new Group3D();
    List.of(objects).forEach(scene::addObject);
    return scene;
  }

  private static Object3D axis(final Vector3D u, final float length) {
    return new Capsule(O, u, 0.03f, length, BLUE);
  }

  private static Object3D arrow(final Point3D from, final Vector3D n, final float length) {
    final Vector3D half = new Vector3D(n);
    half.normalize();
    half.scale(length / 2);
    final Point3D middle = new Point3D(from);
    middle.add(half);
    final Point3D end = new Point3D(middle);
    end.add(half);
    return scene(new Capsule(middle, n, 0.03f, length, BLUE), new Sphere(end, 0.08f, BLUE));
  }

  private static Object3D triangle() {
    final Point3D left = new Point3D(-1.4f, -0.9f, 0.4f), right = new Point3D(1.4f, -0.9f, 0.4f);
    return new Triangle(left, right, new Point3D(0, 1.1f, -0.5f), YELLOW);
  }

  private static Object3D octahedron() {
    final Map<Integer, Point3D> vertices = Map.of(1, new Point3D(1.4f, 0, 0), 2, new Point3D(-1.4f, 0, 0),
        3, new Point3D(0, 1.4f, 0), 4, new Point3D(0, -1.4f, 0), 5, new Point3D(0, 0, 1.4f), 6, new Point3D(0, 0, -1.4f));
    return new TriangularMesh(vertices,
        List.of("1 3 5", "3 2 5", "2 4 5", "4 1 5", "3 1 6", "2 3 6", "4 2 6", "1 4 6"), YELLOW);
  }
}
