package meshes;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;

import arguments.Messages;
import diagnostics.Problem;
import models.Appearance;

/**
 * The materials of a mesh file: reads the files that it names, and finds the appearance of each of its triangles.
 *
 * <p><img src="doc-files/MaterialFiles.png" width="320" height="200" alt="A house with a red roof and a green door">
 */
public final class MaterialFiles {

  private final Path file;
  private final ObjMesh mesh;
  private final List<Problem> problems = new ArrayList<>();
  private final Set<Path> files = new LinkedHashSet<>();
  private final Map<String, MtlMaterial> materials = new HashMap<>();

  /**
   * Reads the materials of a mesh.
   *
   * @param file the file of the mesh
   * @param mesh its contents
   */
  public MaterialFiles(final Path file, final ObjMesh mesh) {
    this.file = file;
    this.mesh = mesh;
    for (final ObjMaterials.Name library : mesh.materials().libraries()) {
      read(library);
    }
    warnOfUnknown();
  }

  /** Warns of each unknown material that a triangle has. */
  private void warnOfUnknown() {
    final List<ObjMaterials.Name> names = mesh.materials().used();
    IntStream.of(mesh.materialOf()).distinct().filter(number -> number >= 0).sorted().mapToObj(names::get)
        .filter(name -> !materials.containsKey(name.text())).forEach(name -> {
          if (name.text().isEmpty()) {
            warn(name.line(), "materialNameless");
          } else {
            warn(name.line(), "materialUnknown", Messages.quote(name.text()));
          }
        });
  }

  /**
   * Whether a mesh refers to materials.
   *
   * @param mesh the mesh
   * @return true if it names a material or a file of materials
   */
  public static boolean areIn(final ObjMesh mesh) {
    return !mesh.materials().libraries().isEmpty() || !mesh.materials().used().isEmpty();
  }

  /** The statement is one name if a file of that name exists, else several, separated by blanks. */
  private void read(final ObjMaterials.Name library) {
    final Path whole = find(file, library.text());
    final String[] names = whole != null ? new String[] {library.text()} : library.text().split("[ \t]+");
    for (final String name : names) {
      final Path found = find(file, name);
      if (name.isEmpty()) {
        warn(library.line(), "libraryNameless");
      } else if (found == null) {
        warn(library.line(), "libraryMissing", Messages.quote(name));
      } else if (files.add(found)) {
        new MtlReader(found, problems::add, files, materials).read();
      }
    }
  }

  /**
   * The file that another refers to: relative to it, by its path or by the last part of the path; null if none.
   *
   * @param from the file that names it
   * @param name the name, in which backslashes separate folders too
   */
  static Path find(final Path from, final String name) {
    final String path = name.replace('\\', '/');
    for (final String candidate : new String[] {name, path, path.substring(path.lastIndexOf('/') + 1)}) {
      try {
        final Path found = from.resolveSibling(candidate).normalize();
        if (!candidate.isEmpty() && Files.isRegularFile(found)) {
          return found;
        }
      } catch (final InvalidPathException noPath) {
        // Another spelling may be valid.
      }
    }
    return null;
  }

  /**
   * The appearances of triangles: first that without a material, then that of each name.
   *
   * @return the appearances
   */
  public List<Appearance> appearances() {
    final List<Appearance> appearances = new ArrayList<>();
    appearances.add(MtlMaterial.DEFAULT.appearance());
    for (final ObjMaterials.Name name : mesh.materials().used()) {
      appearances.add(materials.getOrDefault(name.text(), MtlMaterial.DEFAULT).appearance());
    }
    return appearances;
  }

  /**
   * Which appearance each triangle has.
   *
   * @return indices into the list of appearances
   */
  public int[] ofTriangles() {
    final int[] materialOf = mesh.materialOf(), ofTriangles = new int[mesh.flat().corners().length / 3];
    for (int i = 0; i < materialOf.length; i++) {
      ofTriangles[i] = materialOf[i] + 1;
    }
    return ofTriangles;
  }

  /**
   * The problems of the materials.
   *
   * @return warnings, with file and line
   */
  public List<Problem> problems() {
    return problems;
  }

  /**
   * The files that were read: materials and textures.
   *
   * @return their paths
   */
  public Set<Path> files() {
    return files;
  }

  private void warn(final int line, final String key, final Object... parts) {
    problems.add(new Problem(file.toString(), line, 1, Problem.Severity.WARNING, Messages.text("meshes." + key, parts)));
  }
}
