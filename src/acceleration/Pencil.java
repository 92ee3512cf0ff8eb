package acceleration;

/**
 * The rays of a pinhole camera: they start at one point and pass through the points of a window, L + a X + b Y relative
 * to it. A {@link RayTile} computes the rays of its pixels from that, all at once.
 */
public final class Pencil {

  final double startX;
  final double startY;
  final double startZ;
  final double acrossX;
  final double acrossY;
  final double acrossZ;
  final double upX;
  final double upY;
  final double upZ;
  final double lookX;
  final double lookY;
  final double lookZ;

  /**
   * A pencil of rays.
   *
   * @param start the starting point, in scene units; it is rounded to floats as {@code tracer.Ray.towards} rounds it
   * @param across the vector X, in which columns grow
   * @param up the vector Y, in which rows grow
   * @param look the vector L, to the point of the window whose a and b are 0
   */
  public Pencil(final double[] start, final double[] across, final double[] up, final double[] look) {
    startX = RayRounding.rounded(start[0]);
    startY = RayRounding.rounded(start[1]);
    startZ = RayRounding.rounded(start[2]);
    acrossX = across[0];
    acrossY = across[1];
    acrossZ = across[2];
    upX = up[0];
    upY = up[1];
    upZ = up[2];
    lookX = look[0];
    lookY = look[1];
    lookZ = look[2];
  }

  /**
   * Makes directions of any length: X a + (Y b + L), in this order of operations, which is that of single rays.
   *
   * @param n number of rays
   * @param a the a of each
   * @param b the b of each
   */
  void directions(final int n, final double[] a, final double[] b, final double[] x, final double[] y, final double[] z) {
    component(n, a, b, acrossX, upX, lookX, x);
    component(n, a, b, acrossY, upY, lookY, y);
    component(n, a, b, acrossZ, upZ, lookZ, z);
  }

  private static void component(final int n, final double[] a, final double[] b, final double across, final double up,
      final double look, final double[] direction) {
    for (int i = 0; i < n; i++) {
      direction[i] = across * a[i] + (up * b[i] + look);
    }
  }
}
