package inspection;

import java.awt.Color;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;

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
import scenes.SceneFile;
import view.Camera;
import view.Perspective;
import view.Projection;

/** Scenes for tests, seen from (0, 0, 5). */
public final class SampleScenes {

  private SampleScenes() {
  }

  /** A scene of some objects, whose names are those of their classes. */
  public static SceneFile of(final Projection projection, final boolean facing, final Object3D... objects) {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(projection);
    final Group3D group = new Group3D();
    final Map<Object3D, String> names = new IdentityHashMap<>();
    for (final Object3D object : objects) {
      group.addObject(object);
      names.put(object, "the " + object.getClass().getSimpleName());
    }
    return new SceneFile("sample", 48, 36, new Color(10, 20, 30), facing, camera, group, names, Set.of());
  }

  /** One of each shape, a transformed one, and a group within. */
  public static Object3D[] everyShape() {
    final Group3D group = new Group3D();
    group.addObject(new Sphere(new Point3D(-1.5f, 1, 0.5f), 0.4f, new Color(1, 2, 200)));
    final Vector3D up = new Vector3D(0, 1, 0), right = new Vector3D(1, 0.2f, 0.1f), slanted = new Vector3D(1, 2, 3);
    return new Object3D[] {
        new Sphere(new Point3D(0, 0, 0), 0.5f, Color.RED),
        new Plane(new Point3D(0, -1.5f, 0), new Vector3D(0.1f, 1, 0.1f), Color.GRAY),
        new Cylinder(new Point3D(-1, -0.5f, 0), slanted, 0.3f, 0.8f, Color.GREEN),
        new Capsule(new Point3D(1, -0.5f, 0), slanted, 0.2f, 0.8f, new Color(1, 2, 3, 100)),
        new Box(new Point3D(1.4f, 0.8f, 0), right, up, 0.5f, 0.6f, 0.7f, Color.CYAN),
        new Torus(new Point3D(-1, 0.6f, 0), slanted, 0.4f, 0.12f, Color.MAGENTA),
        new Ellipsoid(new Point3D(0.6f, 0.9f, 0), right, up, 0.5f, 0.2f, 0.3f, Color.ORANGE),
        new Egg(new Point3D(0.1f, -1, 0.3f), slanted, 0.2f, 0.3f, 0.1f, Color.WHITE),
        new TruncatedCone(new Point3D(-1.5f, 0.1f, 0), slanted, 0.2f, 0, 0.5f, Color.BLUE),
        new Triangle(new Point3D(-0.5f, 1, 0), new Point3D(0, 1, 0.2f), new Point3D(-0.2f, 1.4f, 0), Color.PINK),
        TriangularMesh.of(new float[] {0, -1, 1, 0.8f, -1, 1, 0.8f, -0.5f, 1, 0, -0.5f, 1},
            new int[] {0, 1, 2, 0, 2, 3}, null),
        new AffineTransformation(new Vector3f(1, 2, -0.5f), new Vector3f(1, 1, 0), 40, new Vector3f(-0.3f, -1, 1),
            new Torus(new Point3D(), up, 0.3f, 0.1f, Color.YELLOW)),
        new AffineTransformation(new Vector3f(0, 1, 0), 30, group)};
  }

  static Perspective perspective() {
    return new Perspective(45, 4f / 3);
  }
}
