package upnatray;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.StringTokenizer;

import meshes.ObjMesh;
import meshes.ObjReader;
import models.Appearance;
import models.Ellipsoid;
import models.Group3D;
import models.Object3D;
import models.Sphere;
import models.Torus;
import models.TriangularMesh;
import primitives.Point3D;
import primitives.Vector3D;
import view.Camera;
import view.Perspective;

/**
 * A {@code .work} file: a scene of flat colours as ray tracers are compared by, one statement a line. {@code size W H},
 * {@code eye}, {@code look} and {@code up} with three numbers, {@code fov} (vertical, degrees), {@code background r g b},
 * and the objects: {@code mesh FILE.obj r g b}, {@code spheres LIST} (a file of lines {@code x y z radius r g b}),
 * {@code torus x y z R r red green blue} (axis y), {@code ellipsoid x y z a b c red green blue}. Colours are 0 … 1.
 *
 * <p>Reading the file and building the scene are two steps, so that each can be timed.
 */
public final class WorkFile {

  private static final Vector3D X = new Vector3D(1, 0, 0);
  private static final Vector3D Y = new Vector3D(0, 1, 0);

  private final List<Object3D> objects = new ArrayList<>();
  private int width;
  private int height;
  private Point3D eye;
  private Point3D look;
  private Vector3D up = Y;
  private float fov;
  private Color background = Color.BLACK;
  private ObjMesh mesh;
  private Color meshColor;

  private WorkFile() {
  }

  /**
   * Reads a work and the files that it names.
   *
   * @param file the work
   * @return what it says
   * @throws IOException if a file cannot be read, or a line or a mesh is at fault; the message says where
   */
  public static WorkFile read(final Path file) throws IOException {
    final WorkFile work = new WorkFile();
    final List<String> lines = Files.readAllLines(file);
    for (int i = 0; i < lines.size(); i++) {
      try {
        work.readStatement(new StringTokenizer(lines.get(i)));
      } catch (IllegalArgumentException | java.util.NoSuchElementException e) {
        throw new IOException(file + ":" + (i + 1) + ": " + lines.get(i), e);
      }
    }
    if (work.eye == null || work.look == null || work.up == null) {
      throw new IOException(file + ": expected lines eye, look and up");
    }
    return work;
  }

  private void readStatement(final StringTokenizer line) throws IOException {
    if (!line.hasMoreTokens()) {
      return;
    }
    switch (line.nextToken()) {
      case "size" -> {
        width = Integer.parseInt(line.nextToken());
        height = Integer.parseInt(line.nextToken());
      }
      case "eye" -> eye = point(line);
      case "look" -> look = point(line);
      case "up" -> up = new Vector3D(number(line), number(line), number(line));
      case "fov" -> fov = number(line);
      case "background" -> background = color(line);
      case "mesh" -> readMesh(Path.of(line.nextToken()), line);
      case "spheres" -> readSpheres(Path.of(line.nextToken()));
      case "torus" -> objects.add(new Torus(point(line), Y, number(line), number(line), color(line)));
      case "ellipsoid" -> objects.add(
          new Ellipsoid(point(line), X, Y, number(line), number(line), number(line), color(line)));
      default -> throw new IllegalArgumentException();
    }
  }

  private void readMesh(final Path file, final StringTokenizer line) throws IOException {
    final ObjReader.Result reading = new ObjReader(file, false).read();
    if (reading.mesh() == null) {
      throw new IOException(reading.problems().get(0).toString());
    }
    if (mesh != null) {
      throw new IllegalArgumentException("a second mesh");
    }
    mesh = reading.mesh();
    meshColor = color(line);
  }

  private void readSpheres(final Path file) throws IOException {
    for (final String text : Files.readAllLines(file)) {
      final StringTokenizer line = new StringTokenizer(text);
      if (line.hasMoreTokens()) {
        objects.add(new Sphere(point(line), number(line), color(line)));
      }
    }
  }

  private static float number(final StringTokenizer line) {
    return Float.parseFloat(line.nextToken());
  }

  private static Point3D point(final StringTokenizer line) {
    return new Point3D(number(line), number(line), number(line));
  }

  private static Color color(final StringTokenizer line) {
    return new Color(number(line), number(line), number(line));
  }

  /**
   * Builds the scene; once, as the numbers of the mesh are then let go.
   *
   * @return the group of all objects
   */
  public Group3D scene() {
    final Group3D scene = new Group3D();
    if (mesh != null) {
      scene.addObject(TriangularMesh.of(mesh.flat(), Appearance.of(meshColor)));
      mesh = null;
    }
    objects.forEach(scene::addObject);
    scene.getBoundingBox();
    return scene;
  }

  /**
   * The camera.
   *
   * @return a new camera with its projection
   */
  public Camera camera() {
    final Camera camera = new Camera(eye, look, up);
    camera.setProjection(new Perspective(fov, (float) width / height));
    return camera;
  }

  /**
   * Width of the image.
   *
   * @return pixels
   */
  public int width() {
    return width;
  }

  /**
   * Height of the image.
   *
   * @return pixels
   */
  public int height() {
    return height;
  }

  /**
   * Colour of the background.
   *
   * @return the colour
   */
  public Color background() {
    return background;
  }
}
