package rendering;

import static arguments.Arguments.index;
import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import acceleration.RayTile;
import tracer.Ray;
import tracer.RayGenerator;

/** A rectangle of the rays of a picture, as a picture of its own. */
public class GeneratorWindow extends RayGenerator {

  private final RayGenerator rays;
  private final int left;
  private final int bottom;
  private final int samples;

  /**
   * A band of rows of a picture.
   *
   * @param rays the rays of the picture
   * @param bottom its lowest row, from 0
   * @param rows number of rows, at least 1
   * @return the rays of the band
   * @throws IllegalArgumentException if an argument is null, or if the picture does not have these rows
   */
  public static RayGenerator rows(final RayGenerator rays, final int bottom, final int rows) {
    index("bottom", notNull("rays", rays).getHeight() - positive("rows", rows) + 1, bottom);
    return bottom == 0 && rows == rays.getHeight() ? rays
        : new GeneratorWindow(rays, new int[] {0, bottom, rays.getWidth(), rows}, 1);
  }

  /** The rays of a rectangle of pixels whose lower left one is (m, n), each of a square of the given rays. */
  static GeneratorWindow ofPixels(final RayGenerator rays, final int m, final int n, final int width, final int height,
      final int samples) {
    return new GeneratorWindow(rays, new int[] {m * samples, n * samples, width * samples, height * samples}, samples);
  }

  /** The rays of a rectangle: column and row of its first, width and height; so many make up the side of a pixel. */
  GeneratorWindow(final RayGenerator rays, final int[] rectangle, final int samples) {
    super(rays.getCamera(), rectangle[2], rectangle[3]);
    this.rays = rays;
    this.left = rectangle[0];
    this.bottom = rectangle[1];
    this.samples = samples;
  }

  @Override
  public Ray getRay(final int m, final int n) {
    checkPixel(m, n);
    return rays.getRay(left + m, bottom + n);
  }

  @Override
  public void fill(final RayTile tile, final int m, final int n) {
    checkTile(tile, m, n);
    rays.fill(tile, left + m, bottom + n);
  }

  /** The generator that makes the rays in the end. */
  static RayGenerator origin(final RayGenerator generator) {
    return generator instanceof GeneratorWindow window ? origin(window.rays) : generator;
  }

  /** The column of the whole picture in which a ray lies. */
  static int column(final RayGenerator generator, final int m) {
    return generator instanceof GeneratorWindow window ? column(window.rays, window.left + m) / window.samples : m;
  }

  /** The row of the whole picture in which a ray lies. */
  static int row(final RayGenerator generator, final int n) {
    return generator instanceof GeneratorWindow window ? row(window.rays, window.bottom + n) / window.samples : n;
  }
}
