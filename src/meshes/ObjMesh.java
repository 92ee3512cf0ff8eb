package meshes;

import models.MeshData;

/** A mesh as its file has it, before its shading and colours are chosen. */
public final class ObjMesh {

  private final MeshData given;
  private final float[] averages;
  private final int[] materialOf;
  private final ObjMaterials materials;
  private final int firstBareLine;

  ObjMesh(final MeshData given, final float[] averages, final int[] materialOf, final ObjMaterials materials,
      final int firstBareLine) {
    this.given = given;
    this.averages = averages;
    this.materialOf = materialOf;
    this.materials = materials;
    this.firstBareLine = firstBareLine;
  }

  /**
   * The mesh without normals.
   *
   * @return arrays that it shares with others of the same file
   */
  public MeshData flat() {
    return new MeshData(given.coordinates(), given.corners(), null, given.texCoords());
  }

  /**
   * The mesh with the normals of the file, and averages where corners have none.
   *
   * @return arrays that it shares with others of the same file
   */
  public MeshData smooth() {
    if (given.normals() == null) {
      return averaged();
    }
    final float[] own = given.normals().values();
    final float[] values = new float[own.length + averages.length];
    System.arraycopy(own, 0, values, 0, own.length);
    System.arraycopy(averages, 0, values, own.length, averages.length);
    final int[] corners = given.normals().corners().clone();
    for (int i = 0; i < given.corners().length; i++) {
      final int normal = i < corners.length ? corners[i] : MeshBuilder.NONE;
      if (normal < 0 || own[3 * normal] == 0 && own[3 * normal + 1] == 0 && own[3 * normal + 2] == 0) {
        corners[i] = own.length / 3 + given.corners()[i];
      }
    }
    return withNormals(new MeshData.Normals(values, corners));
  }

  /**
   * The mesh with the averages of its facets' normals, whatever normals the file has.
   *
   * @return arrays that it shares with others of the same file
   */
  public MeshData averaged() {
    return withNormals(new MeshData.Normals(averages, given.corners()));
  }

  private MeshData withNormals(final MeshData.Normals normals) {
    return new MeshData(given.coordinates(), given.corners(), normals, given.texCoords());
  }

  /**
   * Whether facets have texture coordinates.
   *
   * @return true if at least one corner names some
   */
  public boolean hasTexCoords() {
    return given.texCoords() != null;
  }

  /**
   * The first facet that has a corner without texture coordinates.
   *
   * @return its line, from 1; 0 if none
   */
  public int firstLineWithoutTexCoords() {
    return firstBareLine;
  }

  /** The material of each triangle, or none at all; −1 for a triangle without one. */
  int[] materialOf() {
    return materialOf;
  }

  ObjMaterials materials() {
    return materials;
  }
}
