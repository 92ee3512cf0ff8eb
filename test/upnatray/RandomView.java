package upnatray;

import java.util.Random;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;
import tracer.RayGenerator;
import view.Angular;
import view.Camera;
import view.Orthographic;
import view.Perspective;
import view.Projection;

/** Cameras of every kind: near, far and within the scene, with all projections and their extremes, and a student's own. */
final class RandomView {

  private RandomView() {
  }

  static Camera camera(final Random random, final RandomScene scene, final double unit) {
    final double away = random.nextInt(3) == 0 ? 0.3 : Math.pow(10, 1.5 * random.nextDouble());
    final Point3D V = scene.point(), C = scene.point();
    V.scale((float) away);
    if (random.nextInt(6) == 0) {
      C.x = V.x;
      C.y = V.y;
    }
    final Camera camera = new Camera(V, C, new Vector3D(0.1f, 1, 0.05f));
    camera.setProjection(projection(random, unit));
    return camera;
  }

  private static Projection projection(final Random random, final double unit) {
    final float aspect = 0.5f + random.nextFloat();
    switch (random.nextInt(12)) {
      case 0: return new Perspective(179, aspect);
      case 1: return new Perspective(0.01f, aspect);
      case 2: return new Perspective(1e-5f, aspect);
      case 3: return new Angular(179);
      case 4: return new Angular(random.nextInt(3) == 0 ? 0.01f : 20 + 150 * random.nextFloat());
      case 5: return new Orthographic((float) (unit * 1e-4), aspect);
      case 6: case 7: case 8: return new Orthographic((float) (unit * (1 + 5 * random.nextDouble())), aspect);
      case 9: return new Oblique(random, unit);
      default: return new Perspective(20 + 80 * random.nextFloat(), aspect);
    }
  }

  /** A student's projection: parallel rays that start on a slanted plane, or rays that start anywhere. */
  private static final class Oblique extends Projection {

    private final boolean parallel;
    private final double unit;
    private final long seed;

    Oblique(final Random random, final double unit) {
      super(4 * unit, 4 * unit);
      this.parallel = random.nextBoolean();
      this.unit = unit;
      this.seed = random.nextLong();
    }

    @Override
    public RayGenerator getRayGenerator(final Camera camera, final int W, final int H) {
      final Vector3D look = camera.getLook();
      final Point3D V = camera.getPosition();
      return new RayGenerator(camera, W, H) {
        @Override
        public Ray getRay(final int m, final int n) {
          final Random pixel = new Random(seed + n * W + m);
          final float x = (float) (unit * (4.0 * m / W - 2)), y = (float) (unit * (4.0 * n / H - 2));
          final float a = parallel ? 0.7f * x : (float) (unit * pixel.nextGaussian());
          return pixel.nextInt(20) == 0 ? Ray.NORAY : new Ray(new Point3D(V.x + x, V.y + y, V.z + a), look);
        }
      };
    }
  }
}
