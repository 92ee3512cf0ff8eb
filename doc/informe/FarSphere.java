import java.awt.Color;
import java.io.File;
import java.io.IOException;
import java.math.BigDecimal;

import javax.imageio.ImageIO;

import models.Group3D;
import models.Object3D;
import models.Sphere;
import primitives.Point3D;
import primitives.Vector3D;
import rendering.RenderSettings;
import rendering.Shading;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import upnatray.Image;
import view.Camera;
import view.Perspective;

/**
 * The picture of the report about numerical trouble: a sphere of radius 1 seen from far away, by the quadratic formula in
 * floats (left) and by {@link Sphere} (right). Prints how many pixels of each are wrong, by exact arithmetic.
 */
public final class FarSphere {

  private static final float DISTANCE = 3_000;
  private static final int SIZE = 240;
  private static final Color COLOUR = new Color(0xE0A030);

  private FarSphere() {
  }

  /** Writes the picture to the file that is the only argument. */
  public static void main(final String... arguments) throws IOException {
    final Camera camera = new Camera(new Point3D(0, 0, DISTANCE), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective((float) Math.toDegrees(2.6 / DISTANCE), 1));
    final Image both = new Image(2 * SIZE, SIZE, Color.WHITE);
    final Object3D[] spheres = {new FloatSphere(), new Sphere(new Point3D(), 1, COLOUR)};
    for (int i = 0; i < spheres.length; i++) {
      final Group3D scene = new Group3D();
      scene.addObject(spheres[i]);
      final Image image = new Image(SIZE, SIZE, Color.WHITE);
      image.synthesis(scene, camera, RenderSettings.STANDARD.withShading(Shading.FACING));
      both.getRaster().setRect(i * SIZE, 0, image.getRaster());
      System.out.println(spheres[i].getClass().getSimpleName() + ": " + wrong(spheres[i], camera) + " of " + SIZE * SIZE);
    }
    ImageIO.write(both, "png", new File(arguments[0]));
  }

  /** Rays that hit where they should miss, or the other way round. */
  private static int wrong(final Object3D sphere, final Camera camera) {
    final RayGenerator rays = camera.getRayGenerator(SIZE, SIZE);
    int wrong = 0;
    for (int n = 0; n < SIZE; n++) {
      for (int m = 0; m < SIZE; m++) {
        final Ray ray = rays.getRay(m, n);
        wrong += sphere.intersectionWith(ray).hits() == hits(ray) ? 0 : 1;
      }
    }
    return wrong;
  }

  /** Whether a ray, in exact arithmetic, hits the sphere, which lies before it. */
  private static boolean hits(final Ray ray) {
    final BigDecimal[] R = exact(ray.startX(), ray.startY(), ray.startZ());
    final BigDecimal[] v = exact(ray.directionX(), ray.directionY(), ray.directionZ());
    final BigDecimal b = dot(R, v);
    return b.multiply(b).compareTo(dot(v, v).multiply(dot(R, R).subtract(BigDecimal.ONE))) >= 0;
  }

  private static BigDecimal[] exact(final double x, final double y, final double z) {
    return new BigDecimal[] {new BigDecimal(x), new BigDecimal(y), new BigDecimal(z)};
  }

  private static BigDecimal dot(final BigDecimal[] a, final BigDecimal[] b) {
    return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
  }

  /** The unit sphere by the formula of the schoolbook, in the assignment's floats. */
  private static final class FloatSphere extends Object3D {

    private FloatSphere() {
      super(COLOUR);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final Point3D R = ray.getStartingPoint();
      final Vector3D v = ray.getDirection();
      final float b = R.x * v.x + R.y * v.y + R.z * v.z;
      final float c = R.x * R.x + R.y * R.y + R.z * R.z - 1;
      final float discriminant = b * b - c;
      final float t = -b - (float) Math.sqrt(discriminant);
      if (!(t > 0)) {
        return Hit.NOHIT;
      }
      final Point3D P = ray.pointAtParameter(t);
      return new Hit(t, P, new Vector3D(P.x, P.y, P.z), this);
    }
  }
}
