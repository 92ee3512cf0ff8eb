package meshes;

import models.AveragedNormals;
import models.MeshData;

/**
 * Builds a mesh while it is read: vertices, and facets that are cut into triangles, with the attributes of their corners.
 * Triangles without area are only counted.
 */
final class MeshBuilder {

  /** A corner without normal or texture coordinates, or a triangle without material. */
  static final int NONE = -1;

  /** Triangles whose areas are tested together, which is faster. */
  private static final int MANY = 1024;

  private final DoubleBuffer coordinates = new DoubleBuffer();
  private final IntBuffer corners = new IntBuffer();
  /** The same for normals and texture coordinates, empty as long as no corner has any. */
  private final IntBuffer normals = new IntBuffer();
  private final IntBuffer texCoords = new IntBuffer();
  /** The material of each triangle; empty as long as none has one. */
  private final IntBuffer materials = new IntBuffer();

  /** The last triangles, whose areas have not been tested yet, and their lines. */
  private final int[] lines = new int[MANY];
  private int unsettled;
  private int dropped;
  private int firstDroppedLine;

  private final AveragedNormals averages;
  private final NewellVector area = new NewellVector();
  private final PolygonTriangulator triangulator = new PolygonTriangulator();
  private int material = NONE;
  private int firstBareLine;

  /** A builder of a mesh. @param averaged whether averages of the facets' normals will be needed */
  MeshBuilder(final boolean averaged) {
    this.averages = averaged ? new AveragedNormals() : null;
  }

  void vertex(final double x, final double y, final double z) {
    coordinates.add(x, y, z);
  }

  int vertices() {
    return coordinates.size / 3;
  }

  /** Sets the material of the following facets. */
  void use(final int itsMaterial) {
    material = itsMaterial;
  }

  /** Adds a facet; false if it is a polygon that crosses itself. */
  boolean facet(final FacetReader facet, final int line) {
    final int[] vertices = facet.vertices();
    final int size = facet.size();
    firstBareLine = firstBareLine == 0 && facet.lacksTexCoords() ? line : firstBareLine;
    if (averages != null) {
      area.compute(coordinates.values, vertices, size);
      averages.add(area.x(), area.y(), area.z(), vertices, size);
    }
    if (size == 3) {
      triangle(facet, 0, 1, 2, line);
      return true;
    }
    final boolean simple = triangulator.cut(coordinates.values, vertices, size);
    for (int i = 0; i < triangulator.triangles(); i++) {
      triangle(facet, triangulator.corner(i, 0), triangulator.corner(i, 1), triangulator.corner(i, 2), line);
    }
    if (triangulator.triangles() == 0) {
      drop(size - 2, line);
    }
    return simple;
  }

  private void triangle(final FacetReader facet, final int a, final int b, final int c, final int line) {
    add(corners, facet.vertices(), a, b, c);
    if (facet.hasNormals() || normals.size > 0) {
      normals.fill(NONE, corners.size - 3);
      add(normals, facet.normals(), a, b, c);
    }
    if (facet.hasTexCoords() || texCoords.size > 0) {
      texCoords.fill(NONE, corners.size - 3);
      add(texCoords, facet.texCoords(), a, b, c);
    }
    if (material != NONE || materials.size > 0) {
      materials.fill(NONE, corners.size / 3 - 1);
      materials.add(material);
    }
    lines[unsettled++] = line;
    if (unsettled == MANY) {
      settle();
    }
  }

  private static void add(final IntBuffer to, final int[] from, final int a, final int b, final int c) {
    to.reserve(3);
    to.values[to.size] = from[a];
    to.values[to.size + 1] = from[b];
    to.values[to.size + 2] = from[c];
    to.size += 3;
  }

  /** Drops those of the last triangles that have no area. */
  void settle() {
    final int first = corners.size / 3 - unsettled;
    int kept = first;
    for (int n = 0; n < unsettled; n++) {
      if (hasArea(3 * (first + n))) {
        if (kept < first + n) {
          move(first + n, kept);
        }
        kept++;
      } else {
        drop(1, lines[n]);
      }
    }
    corners.size = 3 * kept;
    normals.size = Math.min(normals.size, 3 * kept);
    texCoords.size = Math.min(texCoords.size, 3 * kept);
    materials.size = Math.min(materials.size, kept);
    unsettled = 0;
  }

  private void drop(final int triangles, final int line) {
    firstDroppedLine = dropped == 0 || line < firstDroppedLine ? line : firstDroppedLine;
    dropped += triangles;
  }

  private void move(final int from, final int to) {
    for (final IntBuffer buffer : new IntBuffer[] {corners, normals, texCoords}) {
      if (buffer.size > 0) {
        System.arraycopy(buffer.values, 3 * from, buffer.values, 3 * to, 3);
      }
    }
    if (materials.size > 0) {
      materials.values[to] = materials.values[from];
    }
  }

  private boolean hasArea(final int i) {
    final double[] p = coordinates.values;
    final int a = 3 * corners.values[i], b = 3 * corners.values[i + 1], c = 3 * corners.values[i + 2];
    final double ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    final double vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    return uy * vz != uz * vy || uz * vx != ux * vz || ux * vy != uy * vx;
  }

  boolean isEmpty() {
    return corners.size == 0;
  }

  int dropped() {
    return dropped;
  }

  /** Line of the first facet with a triangle that was dropped. */
  int firstDroppedLine() {
    return firstDroppedLine;
  }

  /** The finished mesh. */
  ObjMesh mesh(final CornerAttributes attributes, final ObjMaterials usedMaterials) {
    final MeshData.Normals given = normals.size == 0 ? null
        : new MeshData.Normals(attributes.normals(), normals.toArray());
    final MeshData.TexCoords pairs = texCoords.size == 0 ? null
        : new MeshData.TexCoords(attributes.texCoords(), texCoords.toArray());
    return new ObjMesh(new MeshData(coordinates.toArray(), corners.toArray(), given, pairs),
        averages == null ? null : averages.of(vertices()), materials.toArray(), usedMaterials, firstBareLine);
  }
}
