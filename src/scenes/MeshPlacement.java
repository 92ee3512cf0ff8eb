package scenes;

import java.util.Locale;

import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;

import models.AffineTransformation;
import models.MeshData;
import models.Object3D;

/**
 * Where a mesh is placed, and whether floats are precise enough for that. A mesh in map coordinates, which a translation
 * moves to the origin, is not rounded before that: its vertices are kept relative to its centre, and the centre is placed
 * in double precision.
 */
final class MeshPlacement {

  /** Errors of the vertices, relative to the size of the placed mesh, that do not matter. */
  private static final double TOLERANCE = 3e-7;

  /** Largest rounding of a float, relative to its value. */
  private static final double ROUNDING = 0x1p-24;

  /** Distance, relative to its size, from which on a mesh shows the rounding of its vertices. */
  private static final double FAR = 10_000;

  /** Exponent e such that sizes of meshes from 2 to the power −e to 2 to the power e are far from the limits of floats. */
  private static final int MODERATE = 80;

  private final MeshData data;
  private final double[] min = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
  private final double[] max = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
  private double rounding;
  /** Exponent of 2 of the largest extent. */
  private final int magnitude;

  MeshPlacement(final MeshData data) {
    this.data = data;
    for (final int corner : data.corners()) {
      for (int k = 0; k < 3; k++) {
        final double p = data.coordinates()[3 * corner + k];
        min[k] = Math.min(min[k], p);
        max[k] = Math.max(max[k], p);
        rounding = Math.max(rounding, Math.abs(p - (float) p));
      }
    }
    magnitude = Math.getExponent(Math.max(max[0] - min[0], Math.max(max[1] - min[1], max[2] - min[2])));
  }

  private Point3d centre() {
    return new Point3d((min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2);
  }

  /** The corners of the box about the mesh. */
  private double[] box() {
    final double[] box = new double[3 * 8];
    for (int i = 0; i < box.length; i++) {
      box[i] = (i / 3 >> i % 3 & 1) == 0 ? min[i % 3] : max[i % 3];
    }
    return box;
  }

  /** The corners of all triangles. */
  private double[] vertices() {
    final double[] vertices = new double[3 * data.corners().length];
    for (int i = 0; i < data.corners().length; i++) {
      System.arraycopy(data.coordinates(), 3 * data.corners()[i], vertices, 3 * i, 3);
    }
    return vertices;
  }

  /** Extents of placed points along the axes: in total, and from the origin. */
  private record Reach(double extent, double farthest) {

    static Reach of(final double[] points, final ExactPlacement placement) {
      final Point3d low = new Point3d(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
      final Point3d high = new Point3d(Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY);
      for (int i = 0; i < points.length; i += 3) {
        final Point3d p = placement.applied(new Point3d(points[i], points[i + 1], points[i + 2]));
        low.set(Math.min(low.x, p.x), Math.min(low.y, p.y), Math.min(low.z, p.z));
        high.set(Math.max(high.x, p.x), Math.max(high.y, p.y), Math.max(high.z, p.z));
      }
      return new Reach(distance(low, high), Math.max(distance(low, new Point3d()), distance(high, new Point3d())));
    }

    boolean isFinite() {
      return Float.isFinite((float) farthest);
    }

    boolean isFarAway(final double times) {
      return farthest > times * extent;
    }
  }

  private static double distance(final Point3d p, final Point3d q) {
    return Math.max(Math.abs(p.x - q.x), Math.max(Math.abs(p.y - q.y), Math.abs(p.z - q.z)));
  }

  /** Whether all placed vertices are within the range of floats; mostly the box decides that. */
  boolean isFinite(final ExactPlacement placement) {
    return Reach.of(box(), placement).isFinite() || Reach.of(vertices(), placement).isFinite();
  }

  /**
   * Whether the placed mesh is so far away that floats are too coarse for it. The box shows that it is not, as its extent is
   * at most three times that of the mesh, by a factor √3 each for its diagonals and those of the mesh.
   */
  boolean isFarAway(final ExactPlacement placement) {
    return Reach.of(box(), placement).isFarAway(FAR / 3) && Reach.of(vertices(), placement).isFarAway(FAR);
  }

  /**
   * Whether a placement in floats takes vertices in floats to the right places, up to the rounding of floats.
   */
  boolean isNear(final ExactPlacement exact, final ExactPlacement rounded) {
    if (!isModerate() || isFarAway(exact)) {
      return false;
    }
    final double[] box = box();
    double error = 0;
    for (int i = 0; i < box.length; i += 3) {
      final Point3d p = new Point3d(box[i], box[i + 1], box[i + 2]);
      error = Math.max(error, distance(exact.applied(p), rounded.applied(p)));
    }
    final Vector3d scale = exact.scale();
    final double factor = Math.max(Math.abs(scale.x), Math.max(Math.abs(scale.y), Math.abs(scale.z)));
    final Reach reach = Reach.of(box, exact);
    return error + factor * rounding <= TOLERANCE * reach.extent + ROUNDING * reach.farthest;
  }

  private boolean isModerate() {
    return Math.abs(magnitude) <= MODERATE && Double.isFinite(rounding);
  }

  /** The translation that would move the mesh to the origin, in the notation of scene files. */
  String translationToOrigin(final ExactPlacement placement) {
    final Point3d centre = placement.applied(centre());
    final double extent = Reach.of(box(), placement).extent;
    final int digits = (int) Math.max(0, Math.min(12, 3 - Math.floor(Math.log10(extent))));
    final String format = "%." + digits + "f %." + digits + "f %." + digits + "f";
    return String.format(Locale.ROOT, format, placement.shift().x - centre.x, placement.shift().y - centre.y,
        placement.shift().z - centre.z);
  }

  /** The arrays about the centre of the mesh, scaled to a size of about 1 if its own is near the limits of floats. */
  MeshData aboutCentre() {
    final double[] centre = new double[3], coordinates = data.coordinates().clone();
    centre().get(centre);
    for (int i = 0; i < coordinates.length; i++) {
      final int k = i % 3;
      // Unused vertices may be anywhere.
      coordinates[i] = (Math.max(min[k], Math.min(max[k], coordinates[i])) - centre[k]) / unit();
    }
    return new MeshData(coordinates, data.corners(), data.normals(), data.texCoords());
  }

  /** The unit of the arrays about the centre: a power of 2. */
  private double unit() {
    return isModerate() ? 1 : Math.scalb(1.0, magnitude);
  }

  /** A mesh about its centre, placed. */
  Object3D applied(final ExactPlacement placement, final Object3D mesh) {
    final Vector3d scale = new Vector3d(placement.scale());
    scale.scale(unit());
    return AffineTransformation.of(scale, placement.rotation(), new Vector3d(placement.applied(centre())), mesh);
  }
}
