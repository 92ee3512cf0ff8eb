package acceleration;

import java.util.Random;

/** Tiles of random rays, of all kinds that a ray generator or a transformation can make. */
final class Tiles {

  /** Kinds of tiles; the rays of the last kind have nothing in common. */
  enum Kind { PYRAMID, WIDE, NARROW, FISH_EYE, BENT, PRISM, SLANTED_PRISM, ROUNDED_PRISM, SKEWED, ALL_THE_SAME, ANY }

  private final Random random;
  private final Kind kind;
  private final double[] origin;
  private final double[] x;
  private final double[] y;
  private final double[] z;
  private final double step;
  private final double size;

  private Tiles(final Random random, final Kind kind, final double size) {
    this.random = random;
    this.kind = kind;
    this.size = size;
    final double scale = size * (kind == Kind.ROUNDED_PRISM ? 1e5 : Math.pow(10, 6 * random.nextDouble() - 3));
    origin = new double[] {scale * random.nextGaussian(), scale * random.nextGaussian(),
        random.nextInt(4) == 0 ? 0 : scale * random.nextGaussian()};
    // In the frame of a transformed object, and only there, a ray starts at any double.
    for (int k = 0; k < 3 && kind != Kind.SKEWED; k++) {
      origin[k] = (float) origin[k];
    }
    z = random.nextInt(4) == 0 ? new double[] {0, 0, -1} : unit(random);
    x = random.nextInt(4) == 0 ? perpendicular(new double[] {1, 0.5, 0}) : perpendicular(unit(random));
    y = cross(z, x);
    step = step(kind) * Math.pow(2, random.nextDouble());
  }

  private static double step(final Kind kind) {
    switch (kind) {
      case WIDE: return 0.12;
      case NARROW: return 1e-7;
      case BENT: return 0.05;
      default: return 0.01;
    }
  }

  /**
   * A tile of random extent, optionally with pixels without a ray.
   *
   * @param size order of magnitude of lengths
   */
  static RayTile random(final Random random, final Kind kind, final double size) {
    final RayTile tile = new RayTile();
    final int columns = extent(random), rows = extent(random);
    final Tiles rays = new Tiles(random, kind, size);
    final int present = random.nextInt(4);
    final double m = random.nextInt(40) - 20, n = random.nextInt(40) - 20;
    tile.open(columns, rows);
    final int always = random.nextInt(rows) * RayTile.SIZE + random.nextInt(columns);
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        final int i = row * RayTile.SIZE + column;
        if (i == always || present > 1 || random.nextInt(10) > 4 * (1 - present)) {
          rays.put(tile, i, m + column, n + row);
        }
      }
    }
    tile.close();
    return tile;
  }

  private static int extent(final Random random) {
    return random.nextInt(3) == 0 ? 1 + random.nextInt(RayTile.SIZE) : random.nextInt(8) == 0 ? 1 : RayTile.SIZE;
  }

  private void put(final RayTile tile, final int i, final double column, final double row) {
    final double a = step * column, b = step * row, w = z(a, b);
    final double[] v = {a * x[0] + b * y[0] + w * z[0], a * x[1] + b * y[1] + w * z[1], a * x[2] + b * y[2] + w * z[2]};
    switch (kind) {
      case PRISM: case ROUNDED_PRISM:
        start(tile, i, a, b, 0);
        break;
      case SLANTED_PRISM:
        start(tile, i, a, b, 7 * a - 3 * b);
        break;
      case ANY:
        tile.put(i, size * random.nextGaussian(), size * random.nextGaussian(), size * random.nextGaussian(),
            random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
        break;
      case ALL_THE_SAME:
        tile.put(i, origin[0], origin[1], origin[2], z[0], z[1], z[2]);
        break;
      case SKEWED:
        final double dx = v[0] + 0.5 * v[1], dy = v[1] - 2 * v[2], dz = 3 * v[2];
        final double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        tile.putExactly(i, origin[0], origin[1], origin[2], dx / length, dy / length, dz / length);
        break;
      default:
        tile.put(i, origin[0], origin[1], origin[2], v[0], v[1], v[2]);
    }
  }

  private void start(final RayTile tile, final int i, final double column, final double row, final double ahead) {
    final double a = size * column, b = size * row, c = size * ahead;
    tile.put(i, origin[0] + a * x[0] + b * y[0] + c * z[0], origin[1] + a * x[1] + b * y[1] + c * z[1],
        origin[2] + a * x[2] + b * y[2] + c * z[2], z[0], z[1], z[2]);
  }

  /** Component along the view of the direction through (a, b). */
  private double z(final double a, final double b) {
    switch (kind) {
      case FISH_EYE: return Math.sqrt(Math.max(0.04, 1 - a * a - b * b));
      case BENT: return 1 + 0.3 * Math.sin(9 * a) * Math.cos(7 * b);
      default: return 1;
    }
  }

  private static double[] unit(final Random random) {
    final double[] v = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
    final double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return new double[] {v[0] / length, v[1] / length, v[2] / length};
  }

  private double[] perpendicular(final double[] v) {
    final double[] p = cross(v, z);
    final double length = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    return new double[] {p[0] / length, p[1] / length, p[2] / length};
  }

  private static double[] cross(final double[] a, final double[] b) {
    return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  /** A random pixel that has a ray. */
  static int anyRay(final Random random, final RayTile tile) {
    while (true) {
      final int i = random.nextInt(tile.rows()) * RayTile.SIZE + random.nextInt(tile.columns());
      if (tile.isPresent(i)) {
        return i;
      }
    }
  }

  static double[] start(final RayTile tile, final int i) {
    return new double[] {tile.startX(i), tile.startY(i), tile.startZ(i)};
  }

  static double[] direction(final RayTile tile, final int i) {
    return new double[] {tile.directionX(i), tile.directionY(i), tile.directionZ(i)};
  }
}
