package view;

import static arguments.Arguments.notNull;
import static arguments.Arguments.wrong;
import static arguments.Arguments.wrongState;

import tracer.RayGenerator;

/**
 * A projection of the scene onto a plane perpendicular to the camera's view, through a window centred on it. Seen from
 * the camera, the window's x is to the right and its y up.
 */
public abstract class Projection {

  private final double w;
  private final double h;

  /**
   * A projection through a window.
   *
   * @param w width of the window in scene units, &gt; 0
   * @param h height of the window in scene units, &gt; 0
   * @throws IllegalArgumentException if a size is not positive or does not fit in a float
   */
  protected Projection(final double w, final double h) {
    this.w = size("w", w);
    this.h = size("h", h);
  }

  private static double size(final String name, final double size) {
    if (!((float) size > 0 && (float) size < Float.POSITIVE_INFINITY)) {
      throw wrong("positive", name, size);
    }
    return size;
  }

  /**
   * The rule of the projection: the z, in the camera's frame, at which the ray of the window's point (x, y) passes
   * through (x, y, z). The rays of the library's projections start at the camera, except parallel ones, which start at
   * that point.
   *
   * @param x first coordinate of a point of the window, from −w/2 to w/2
   * @param y second coordinate, from −h/2 to h/2
   * @return z; NaN where there is no ray; by default NaN everywhere, for projections that follow another rule
   */
  public double zAt(final double x, final double y) {
    return Double.NaN;
  }

  /**
   * The rays of a camera, by this projection.
   *
   * @param camera the camera, which must hold this projection
   * @param W width of the image in pixels, at least 1
   * @param H height of the image in pixels, at least 1
   * @return the generator of the rays
   * @throws IllegalArgumentException if the camera is null or the image has no pixel
   * @throws IllegalStateException if the camera holds another projection, or none
   */
  public abstract RayGenerator getRayGenerator(Camera camera, int W, int H);

  /**
   * Width of the window.
   *
   * @return width in scene units
   */
  public float getWidth() {
    return (float) w;
  }

  /**
   * Height of the window.
   *
   * @return height in scene units
   */
  public float getHeight() {
    return (float) h;
  }

  /** x of the centre of the pixels of column m of W. */
  final double columnCentre(final int m, final int W) {
    return centre(w, W, m);
  }

  /** y of the centre of the pixels of row n of H. */
  final double rowCentre(final int n, final int H) {
    return centre(h, H, n);
  }

  /** x of the centres of the pixels of some columns of W, from column m on. */
  final double[] columnCentres(final int m, final int columns, final int W) {
    final double[] centres = new double[columns];
    for (int i = 0; i < columns; i++) {
      centres[i] = columnCentre(m + i, W);
    }
    return centres;
  }

  /** y of the centres of the pixels of some rows of H, from row n on. */
  final double[] rowCentres(final int n, final int rows, final int H) {
    final double[] centres = new double[rows];
    for (int i = 0; i < rows; i++) {
      centres[i] = rowCentre(n + i, H);
    }
    return centres;
  }

  private static double centre(final double size, final int pixels, final int i) {
    return (i + 0.5) * size / pixels - size / 2;
  }

  /** Checks that a camera holds this projection, and returns the camera. */
  final Camera holding(final Camera camera) {
    if (notNull("camera", camera).getProjection() != this) {
      throw wrongState("otherCamera");
    }
    return camera;
  }
}
