package scenes;

import java.util.Locale;

import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;

import models.AffineTransformation;
import models.MeshData;
import models.Object3D;

/**
 * Where a mesh is placed, and whether floats are precise enough for that. A mesh in the coordinates of a map, which a
 * translation brings to the origin, is not rounded before: its vertices are kept about its centre, and the centre is placed
 * in double precision.
 */
final class MeshPlacement {

  /** Errors of the vertices up to this part of the size of the placed mesh are of no consequence. */
  private static final double TOLERANCE = 5e-7;

  /** Largest rounding of a float, relative to its value. */
  private static final double ROUNDING = 0x1p-24;

  /** A mesh farther away than so many times its size shows steps in its vertices. */
  private static final double FAR = 10_000;

  private final MeshData data;
  private final double[] min = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
  private final double[] max = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
  private double rounding;

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
  }

  private Point3d centre() {
    return new Point3d((min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2);
  }

  private Point3d corner(final int number) {
    return new Point3d((number & 1) == 0 ? min[0] : max[0], (number & 2) == 0 ? min[1] : max[1],
        (number & 4) == 0 ? min[2] : max[2]);
  }

  /** Whether a placement takes the mesh to coordinates that floats hold. */
  boolean isFinite(final ExactPlacement placement) {
    boolean finite = true;
    for (int n = 0; n < 8; n++) {
      final Point3d p = placement.applied(corner(n));
      finite &= Float.isFinite((float) p.x) && Float.isFinite((float) p.y) && Float.isFinite((float) p.z);
    }
    return finite;
  }

  /**
   * Whether a placement of rounded numbers takes rounded vertices to where they are to be, as far as floats can say that.
   */
  boolean isNear(final ExactPlacement exact, final ExactPlacement rounded) {
    if (isFarAway(exact)) {
      return false;
    }
    double error = 0;
    for (int n = 0; n < 8; n++) {
      error = Math.max(error, distance(exact.applied(corner(n)), rounded.applied(corner(n))));
    }
    final Vector3d scale = exact.scale();
    final double factor = Math.max(Math.abs(scale.x), Math.max(Math.abs(scale.y), Math.abs(scale.z)));
    return error + factor * rounding <= TOLERANCE * extent(exact) + ROUNDING * farthest(exact);
  }

  private static double distance(final Point3d p, final Point3d q) {
    return Math.max(Math.abs(p.x - q.x), Math.max(Math.abs(p.y - q.y), Math.abs(p.z - q.z)));
  }

  /** Largest extent of the placed mesh along an axis. */
  private double extent(final ExactPlacement placement) {
    double extent = 0;
    for (int n = 0; n < 8; n++) {
      for (int other = 0; other < n; other++) {
        extent = Math.max(extent, distance(placement.applied(corner(n)), placement.applied(corner(other))));
      }
    }
    return extent;
  }

  /** Largest absolute coordinate of the placed mesh. */
  private double farthest(final ExactPlacement placement) {
    double farthest = 0;
    for (int n = 0; n < 8; n++) {
      farthest = Math.max(farthest, distance(placement.applied(corner(n)), new Point3d()));
    }
    return farthest;
  }

  /** Whether the placed mesh is so far away that floats are too coarse for it. */
  boolean isFarAway(final ExactPlacement placement) {
    return farthest(placement) > FAR * extent(placement);
  }

  /** The translation that would bring the mesh to the origin, as a scene file has it. */
  String translationToOrigin(final ExactPlacement placement) {
    final Point3d centre = placement.applied(centre());
    final int digits = (int) Math.max(0, Math.min(12, 3 - Math.floor(Math.log10(extent(placement)))));
    final String format = "%." + digits + "f %." + digits + "f %." + digits + "f";
    return String.format(Locale.ROOT, format, placement.shift().x - centre.x, placement.shift().y - centre.y,
        placement.shift().z - centre.z);
  }

  /** The arrays about the centre of the mesh. */
  MeshData aboutCentre() {
    final double[] centre = new double[3], coordinates = data.coordinates().clone();
    centre().get(centre);
    for (int i = 0; i < coordinates.length; i++) {
      coordinates[i] -= centre[i % 3];
    }
    return new MeshData(coordinates, data.corners(), data.normals(), data.texCoords());
  }

  /** A mesh about its centre where a placement takes it. */
  Object3D applied(final ExactPlacement placement, final Object3D mesh) {
    return AffineTransformation.of(placement.scale(), placement.rotation(), new Vector3d(placement.applied(centre())), mesh);
  }
}
