package meshes;

import static arguments.Arguments.notNull;

import java.awt.Color;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.stream.Collectors;

import diagnostics.Problem;
import materials.Material;
import materials.Texture;
import models.Appearance;
import models.TriangularMesh;

/**
 * Reads meshes from Wavefront OBJ files, also zipped, for your own program:
 *
 * <pre>{@code
 * TriangularMesh cow = ObjFile.read(java.nio.file.Path.of("cow.obj"), Color.PINK);
 * }</pre>
 *
 * <p><img src="doc-files/ObjFile.png" width="320" height="213" alt="A teapot, cups and a plate">
 *
 * <p>A mesh is smooth: it has the normals of its file, and where corners have none, averages of the facets around them.
 * Harmless faults, such as a facet without area, are ignored silently; {@code UPNaTRay --check} reports them for a scene
 * file.
 */
public final class ObjFile {

  private ObjFile() {
  }

  /** A file is not a valid mesh. The message has a line for each error: file, line, column, and what is wrong. */
  public static final class InvalidException extends UncheckedIOException {
    private static final long serialVersionUID = 1L;

    InvalidException(final String message) {
      super(message, new IOException(message));
    }
  }

  /**
   * Reads a smooth mesh of one colour.
   *
   * @param file the file
   * @param color colour of all triangles
   * @return the mesh
   * @throws InvalidException if the file cannot be read or holds no mesh
   * @throws IllegalArgumentException if an argument is null
   */
  public static TriangularMesh read(final Path file, final Color color) {
    return TriangularMesh.of(mesh(file).smooth(), Appearance.of(color));
  }

  /**
   * Reads a smooth mesh of a material.
   *
   * @param file the file
   * @param material material of all triangles
   * @return the mesh
   * @throws InvalidException if the file cannot be read or holds no mesh
   * @throws IllegalArgumentException if an argument is null
   */
  public static TriangularMesh read(final Path file, final Material material) {
    return TriangularMesh.of(mesh(file).smooth(), Appearance.of(material));
  }

  /**
   * Reads a smooth mesh with a texture. A triangle with a corner without texture coordinates has the texture's mean colour.
   *
   * @param file the file
   * @param texture the texture, see {@link TextureFile}
   * @return the mesh
   * @throws InvalidException if the file cannot be read or holds no mesh
   * @throws IllegalArgumentException if an argument is null
   */
  public static TriangularMesh read(final Path file, final Texture texture) {
    return TriangularMesh.of(mesh(file).smooth(), Appearance.of(texture));
  }

  /**
   * Reads a smooth mesh in the colours and textures of its material files ({@code .mtl}). Facets without a material, or
   * with an unknown one, are light grey.
   *
   * @param file the file
   * @return the mesh
   * @throws InvalidException if the file cannot be read or holds no mesh
   * @throws IllegalArgumentException if the file is null
   */
  public static TriangularMesh read(final Path file) {
    final ObjMesh mesh = mesh(file);
    final MaterialFiles materials = new MaterialFiles(file, mesh);
    return TriangularMesh.of(mesh.smooth(), materials.appearances(), materials.ofTriangles());
  }

  private static ObjMesh mesh(final Path file) {
    final ObjReader.Result reading = new ObjReader(notNull("file", file), true).read();
    if (reading.mesh() == null) {
      throw new InvalidException(reading.problems().stream().filter(Problem::isError).map(Problem::toString)
          .collect(Collectors.joining(System.lineSeparator())));
    }
    if (reading.large() != null) {
      throw new InvalidException(reading.large().toString());
    }
    return reading.mesh();
  }
}
