package view;

import java.util.Random;

import primitives.Point3D;
import primitives.Vector3D;

/** A camera's frame worked out in double by other means than {@link Camera}'s: the oracle of its tests. */
final class CameraFrame {

  final Point3D V;
  final Point3D C;
  final Vector3D up;
  private final double[] x;
  private final double[] y;
  private final double[] z;

  CameraFrame(final Point3D V, final Point3D C, final Vector3D up) {
    this.V = V;
    this.C = C;
    this.up = up;
    z = unit((double) V.x - C.x, (double) V.y - C.y, (double) V.z - C.z);
    final double along = up.x * z[0] + up.y * z[1] + up.z * z[2];
    y = unit(up.x - along * z[0], up.y - along * z[1], up.z - along * z[2]);
    x = new double[] {y[1] * z[2] - y[2] * z[1], y[2] * z[0] - y[0] * z[2], y[0] * z[1] - y[1] * z[0]};
  }

  /** A camera anywhere, near or far from what it looks at, with an up vector of any length that is not along the view. */
  static CameraFrame random(final Random random) {
    final float scale = (float) Math.pow(10, 6 * random.nextDouble() - 3);
    final Point3D V = new Point3D(gauss(random, scale), gauss(random, scale), gauss(random, scale));
    final Point3D C = new Point3D(V.x + gauss(random, scale), V.y + gauss(random, scale), V.z + gauss(random, scale));
    while (true) {
      final Vector3D up = new Vector3D(gauss(random, scale), gauss(random, scale), gauss(random, scale));
      final double[] u = unit(up.x, up.y, up.z);
      final CameraFrame frame = new CameraFrame(V, C, up);
      if (Math.abs(u[0] * frame.z[0] + u[1] * frame.z[1] + u[2] * frame.z[2]) < 0.99) {
        return frame;
      }
    }
  }

  private static float gauss(final Random random, final float scale) {
    return scale * (float) random.nextGaussian();
  }

  private static double[] unit(final double a, final double b, final double c) {
    final double length = Math.sqrt(a * a + b * b + c * c);
    return new double[] {a / length, b / length, c / length};
  }

  Camera camera(final Projection projection) {
    final Camera camera = new Camera(V, C, up);
    camera.setProjection(projection);
    return camera;
  }

  /** A vector of the camera's frame, in the scene. */
  double[] vector(final double a, final double b, final double c) {
    return new double[] {a * x[0] + b * y[0] + c * z[0], a * x[1] + b * y[1] + c * z[1], a * x[2] + b * y[2] + c * z[2]};
  }

  /** A vector of the camera's frame, in the scene and of unit length. */
  double[] direction(final double a, final double b, final double c) {
    final double[] v = vector(a, b, c);
    return unit(v[0], v[1], v[2]);
  }

  /** A point of the camera's frame, in the scene. */
  double[] point(final double a, final double b, final double c) {
    final double[] v = vector(a, b, c);
    return new double[] {V.x + v[0], V.y + v[1], V.z + v[2]};
  }

  /** Largest coordinate of the camera's position, to which the rounding of floats near it is relative. */
  double size() {
    return Math.max(Math.abs(V.x), Math.max(Math.abs(V.y), Math.abs(V.z)));
  }
}
