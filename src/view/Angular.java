package view;

import static arguments.Arguments.between;

import tracer.RayGenerator;

/**
 * A fish-eye: the scene is projected onto the cap of a sphere about the camera whose rim, of half-angle ω/2, lies in the
 * plane z = −1 of the camera's frame. So the window is square with w = h = 2 tan(ω/2), and pixels outside the circle of
 * the rim have no ray.
 */
public class Angular extends Projection {

  private final double rim2;

  /**
   * A fish-eye.
   *
   * @param omega full angle of view in degrees, 0 &lt; ω &lt; 180
   * @throws IllegalArgumentException if ω is out of its range
   */
  public Angular(final float omega) {
    super(2 * rim(omega), 2 * rim(omega));
    rim2 = rim(omega) * rim(omega);
  }

  private static double rim(final float omega) {
    return StrictMath.tan(Math.toRadians(between("omega", 0, 180, omega)) / 2);
  }

  @Override
  public RayGenerator getRayGenerator(final Camera camera, final int W, final int H) {
    return new AngularRayGenerator(holding(camera), W, H);
  }

  /** The cap: part of a sphere of radius 1 / cos(ω/2), the square of which is 1 + tan²(ω/2). */
  @Override
  public double zAt(final double x, final double y) {
    final double rho2 = x * x + y * y;
    return rho2 <= rim2 ? -Math.sqrt(1 + rim2 - rho2) : Double.NaN;
  }

  /** Rays from the camera through the points of the cap. */
  static class AngularRayGenerator extends CentralRayGenerator {

    AngularRayGenerator(final Camera camera, final int W, final int H) {
      super(camera, W, H);
    }
  }
}
