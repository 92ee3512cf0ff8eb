package rendering;

import acceleration.SegmentTile;
import materials.Material;
import tracer.Hit;
import tracer.Ray;

/**
 * The surfaces that the rays of a tile see, in the order in which they were added: the numbers of {@link ViewedSurface}
 * as arrays. Mutable, one for each thread.
 */
final class TileSurfaces {

  /** Greatest number of surfaces. */
  static final int MOST = SegmentTile.MOST;

  final double[] x = new double[MOST];
  final double[] y = new double[MOST];
  final double[] z = new double[MOST];
  /** The geometric normals on the viewer's side. */
  final double[] geometricX = new double[MOST];
  final double[] geometricY = new double[MOST];
  final double[] geometricZ = new double[MOST];
  /** The shading normals on the viewer's side. */
  final double[] normalX = new double[MOST];
  final double[] normalY = new double[MOST];
  final double[] normalZ = new double[MOST];
  /** Unit vectors towards the viewer, and their cosines to the shading normals. */
  final double[] viewX = new double[MOST];
  final double[] viewY = new double[MOST];
  final double[] viewZ = new double[MOST];
  final double[] cosine = new double[MOST];
  /** The offsets from the surfaces at which rays start. */
  final double[] offset = new double[MOST];
  final boolean[] outside = new boolean[MOST];
  final Material[] materials = new Material[MOST];
  final Ray[] rays = new Ray[MOST];
  final Hit[] hits = new Hit[MOST];

  private int count;

  /** Removes all surfaces. */
  void clear() {
    count = 0;
  }

  int count() {
    return count;
  }

  /** Whether the accuracy of a hit is known, so that a ray that leaves it needs no object. */
  boolean isExact(final int i) {
    return hits[i].errorBound() < Double.POSITIVE_INFINITY;
  }

  /** Adds the surface of a hit, as the ray sees it. */
  void add(final Ray ray, final Hit hit, final ViewedSurface viewed, final Material material) {
    final int i = count++;
    rays[i] = ray;
    hits[i] = hit;
    materials[i] = material;
    x[i] = hit.pointX();
    y[i] = hit.pointY();
    z[i] = hit.pointZ();
    geometricX[i] = viewed.geometricX();
    geometricY[i] = viewed.geometricY();
    geometricZ[i] = viewed.geometricZ();
    normalX[i] = viewed.normalX();
    normalY[i] = viewed.normalY();
    normalZ[i] = viewed.normalZ();
    viewX[i] = -ray.directionX();
    viewY[i] = -ray.directionY();
    viewZ[i] = -ray.directionZ();
    cosine[i] = normalX[i] * viewX[i] + normalY[i] * viewY[i] + normalZ[i] * viewZ[i];
    outside[i] = viewed.isSeenFromOutside();
    offset[i] = hit.offset();
  }
}
