package scenes;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

import arguments.Messages;
import diagnostics.Problem;
import diagnostics.SimilarFile;
import meshes.MaterialFiles;
import meshes.ObjMesh;
import meshes.ObjReader;
import models.Appearance;
import models.MeshData;
import models.Object3D;
import models.TriangularMesh;

/**
 * The meshes of a scene file. They are looked for in the scene's own directory, then in {@code scenes} under the working
 * directory; each file is read once, when the first object shows it.
 */
final class MeshFiles {

  /** Endings of files that may be suggested in place of a missing one. */
  private static final String[] MESHES = {".obj", ".zip"};
  private static final String[] IMAGES = {".png", ".jpg", ".jpeg", ".gif", ".bmp"};

  /** A file and its contents. */
  private final class MeshFile {

    private final Path path;
    private final int offset;
    private boolean averaged;
    private ObjMesh mesh;
    private boolean read;
    private MaterialFiles materials;

    MeshFile(final Path path, final int offset) {
      this.path = path;
      this.offset = offset;
    }

    /** The mesh; null if the file is invalid, which is reported once. */
    ObjMesh mesh() {
      if (!read) {
        read = true;
        final ObjReader.Result reading = new ObjReader(path, averaged).read();
        for (final Problem problem : reading.problems()) {
          problems.add(offset, problem);
        }
        mesh = reading.mesh();
      }
      return mesh;
    }

    /** The materials of the mesh, whose problems are reported once. */
    MaterialFiles materials() {
      if (materials == null) {
        materials = new MaterialFiles(path, mesh());
        for (final Problem problem : materials.problems()) {
          problems.add(offset, problem);
        }
        materialFiles.addAll(materials.files());
      }
      return materials;
    }
  }

  /** A mesh with or without normals. */
  private final class MeshModel implements Model {

    private final MeshFile file;
    private final boolean flat;
    private final boolean promediated;
    private MeshPlacement extent;
    private ColouredMesh near;
    private ColouredMesh far;

    MeshModel(final MeshFile file, final boolean flat, final boolean promediated) {
      this.file = file;
      this.flat = flat;
      this.promediated = promediated;
    }

    @Override
    public boolean hasMaterials() {
      return file.mesh() == null || MaterialFiles.areIn(file.mesh());
    }

    @Override
    public String textureFault() {
      return file.mesh() == null || file.mesh().hasTexCoords() ? null : "noTexCoords";
    }

    @Override
    public Object3D at(final Placement placement, final Appearance appearance) {
      return placed(placement, appearance);
    }

    /** The mesh under a transformation; null if its file is invalid. */
    @Override
    public Object3D placed(final Placement placement, final Appearance appearance) {
      if (file.mesh() == null) {
        return null;
      }
      if (near == null) {
        final MeshData data = flat ? file.mesh().flat() : promediated ? file.mesh().averaged() : file.mesh().smooth();
        extent = new MeshPlacement(data);
        near = new ColouredMesh(data);
      }
      warnOfBareFacets(appearance);
      final ExactPlacement exact = placement.exact();
      if (extent.isNear(exact, placement.rounded())) {
        return placement.applied(near.of(appearance, file));
      }
      far = far != null ? far : new ColouredMesh(extent.aboutCentre());
      return extent.applied(exact, far.of(appearance, file));
    }

    @Override
    public void check(final Placement placement, final int offset) {
      if (near != null && !extent.isFinite(placement.exact())) {
        problems.error(offset, "meshTooFar");
      } else if (near != null && extent.isFarAway(placement.exact())) {
        problems.warning(offset, "meshFar", extent.translationToOrigin(placement.exact()));
      }
    }

    private void warnOfBareFacets(final Appearance appearance) {
      final int line = file.mesh().firstLineWithoutTexCoords();
      if (appearance != null && appearance.texture() != null && line > 0 && bare.add(file.path)) {
        problems.add(file.offset, new Problem(file.path.toString(), line, 1, Problem.Severity.WARNING,
            Messages.text("scenes.someTexCoords")));
      }
    }
  }

  /** A mesh in the appearances of the objects that show it, which share its geometry. */
  private static final class ColouredMesh {

    private final MeshData data;
    private final Map<Appearance, TriangularMesh> coloured = new HashMap<>();
    private TriangularMesh any;

    ColouredMesh(final MeshData data) {
      this.data = data;
    }

    /** The mesh with an appearance; null for the materials of its file. */
    TriangularMesh of(final Appearance appearance, final MeshFile file) {
      TriangularMesh mesh = coloured.get(appearance);
      if (mesh == null) {
        mesh = appearance == null ? TriangularMesh.of(data, file.materials().appearances(), file.materials().ofTriangles())
            : any != null ? any.with(appearance) : TriangularMesh.of(data, appearance);
        any = mesh;
        coloured.put(appearance, mesh);
      }
      return mesh;
    }
  }

  private final Path scene;
  private final Problems problems;
  private final Map<Path, MeshFile> meshes = new HashMap<>();
  private final Set<Path> materialFiles = new HashSet<>();
  /** The files whose facets without texture coordinates have been reported. */
  private final Set<Path> bare = new HashSet<>();

  MeshFiles(final Path scene, final Problems problems) {
    this.scene = scene;
    this.problems = problems;
  }

  /** The model of a mesh file; if there is no such file, that is reported, and the result is null. */
  Model find(final String name, final int offset, final boolean flat, final boolean promediated) {
    final Path path = existing(name, offset, "noFile");
    if (path == null) {
      return null;
    }
    final MeshFile file = meshes.computeIfAbsent(path, found -> new MeshFile(found, offset));
    file.averaged |= !flat;
    return new MeshModel(file, flat, promediated);
  }

  /** The files of the meshes found so far, and those of their materials. */
  Set<Path> paths() {
    final Set<Path> paths = new HashSet<>(meshes.keySet());
    paths.addAll(materialFiles);
    return paths;
  }

  /**
   * The file of a name; if there is none, that is reported with all places where it was looked for, and the result is
   * null.
   */
  Path existing(final String name, final int offset, final String message) {
    try {
      final Set<Path> places = places(name);
      Path found = first(places);
      if (found == null && File.separatorChar == '/' && name.indexOf('\\') >= 0) {
        found = first(places(name.replace('\\', '/')));
        if (found != null) {
          problems.warning(offset, "backslash", Messages.quote(name));
        }
      }
      if (found == null) {
        problems.error(offset, message, Messages.quote(name), tried(places)
            + SimilarFile.question(scene.resolveSibling(name), message.equals("noFile") ? MESHES : IMAGES));
      }
      return found;
    } catch (final InvalidPathException noName) {
      problems.error(offset, "noPath", Messages.quote(name));
      return null;
    }
  }

  private Set<Path> places(final String name) {
    final Set<Path> places = new LinkedHashSet<>();
    places.add(scene.resolveSibling(name).normalize());
    places.add(Path.of("scenes").resolve(name).normalize());
    return places;
  }

  private static Path first(final Set<Path> places) {
    for (final Path place : places) {
      if (Files.isRegularFile(place)) {
        return place;
      }
    }
    return null;
  }

  private static String tried(final Set<Path> places) {
    final StringBuilder tried = new StringBuilder();
    for (final Path place : places) {
      tried.append(tried.length() == 0 ? "" : ", ").append(place);
      tried.append(Files.isDirectory(place) ? " " + Messages.text("scenes.isFolder") : "");
    }
    return tried.toString();
  }
}
