package examples;

import static examples.Numbers.cos;
import static examples.Numbers.sin;

/**
 * A torus knot: a tube that goes three times round a torus while it winds seven times about its tube, and so comes back to
 * where it began. A closed mesh, without an edge of its own.
 *
 * <p>The middle of the tube is at ((R + r cos 7a) cos 3a, r sin 7a, (R + r cos 7a) sin 3a). Its sections stand on the
 * normal of the torus, which turns with the curve, so that the last section fits the first without a twist.
 */
final class Knot {

  private static final int ROUNDS = 3;
  private static final int WINDINGS = 7;
  private static final double R = 2;
  private static final double r = 0.75;
  private static final double TUBE = 0.27;
  private static final int SECTIONS = 700;
  private static final int SIDES = 32;

  private Knot() {
  }

  /** The text of the file. */
  static String text() {
    final MeshText mesh = new MeshText("A torus knot: three times round, seven windings. Closed; the axis is y.",
        "Written by test/examples/Knot.java.");
    final int[][] grid = new int[SECTIONS][];
    for (int i = 0; i < SECTIONS; i++) {
      grid[i] = section(mesh, 360.0 * i / SECTIONS);
    }
    mesh.rings(grid, true);
    return mesh.toString();
  }

  private static int[] section(final MeshText mesh, final double a) {
    final double around = ROUNDS * a, about = WINDINGS * a, ring = R + r * cos(about);
    final double[] normal = {cos(about) * cos(around), sin(about), cos(about) * sin(around)};
    final double[] tangent = {
        -WINDINGS * r * sin(about) * cos(around) - ROUNDS * ring * sin(around),
        WINDINGS * r * cos(about),
        -WINDINGS * r * sin(about) * sin(around) + ROUNDS * ring * cos(around)};
    final double[] side = cross(tangent, normal);
    final int[] points = new int[SIDES];
    for (int j = 0; j < SIDES; j++) {
      final double c = TUBE * cos(360.0 * j / SIDES), s = TUBE * sin(360.0 * j / SIDES);
      points[j] = mesh.point(ring * cos(around) + c * normal[0] + s * side[0],
          r * sin(about) + c * normal[1] + s * side[1], ring * sin(around) + c * normal[2] + s * side[2]);
    }
    return points;
  }

  /** The unit vector along the cross product. */
  private static double[] cross(final double[] u, final double[] v) {
    final double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
    final double length = Math.sqrt(x * x + y * y + z * z);
    return new double[] {x / length, y / length, z / length};
  }
}
