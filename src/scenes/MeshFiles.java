package scenes;

import java.awt.Color;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

import arguments.Messages;
import diagnostics.Problem;
import meshes.ObjReader;
import models.Object3D;
import models.TriangularMesh;

/**
 * The meshes of a scene file. They are looked for in the scene's own directory, then in {@code scenes} under the working
 * directory; each file is read once, when the first object shows it, and shared by all objects of a colour.
 */
final class MeshFiles {

  /** A file with what was read of it. */
  private final class MeshModel implements Model {

    private final Path file;
    private final int offset;
    private final Map<Color, Object3D> coloured = new HashMap<>();
    private ObjReader.Mesh mesh;
    private boolean read;

    MeshModel(final Path file, final int offset) {
      this.file = file;
      this.offset = offset;
    }

    @Override
    public Object3D at(final Placement placement, final Appearance look) {
      return placed(placement, look);
    }

    /** The mesh under a transformation; null if its file is at fault, which is told once. */
    @Override
    public Object3D placed(final Placement placement, final Appearance look) {
      if (!read) {
        read = true;
        final ObjReader.Result reading = new ObjReader(file).read();
        for (final Problem problem : reading.problems()) {
          problems.add(offset, problem);
        }
        mesh = reading.mesh();
      }
      if (mesh == null) {
        return null;
      }
      Object3D object = coloured.get(look.color());
      if (object == null) {
        object = TriangularMesh.of(mesh.coordinates(), mesh.corners(), look.color());
        coloured.put(look.color(), object);
      }
      return placement.applied(object);
    }
  }

  private final Path scene;
  private final Problems problems;
  private final Map<Path, MeshModel> models = new HashMap<>();

  MeshFiles(final Path scene, final Problems problems) {
    this.scene = scene;
    this.problems = problems;
  }

  /** The model of a mesh file; null, and told, if there is no such file. */
  Model find(final String name, final int offset) {
    final Path file = existing(name, offset, "noFile");
    if (file == null) {
      return null;
    }
    MeshModel model = models.get(file);
    if (model == null) {
      model = new MeshModel(file, offset);
      models.put(file, model);
    }
    return model;
  }

  /** The files of the meshes found so far. */
  Set<Path> paths() {
    return Set.copyOf(models.keySet());
  }

  /** The file of a name; null, and told with all places where it was looked for, if there is none. */
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
        problems.error(offset, message, Messages.quote(name), tried(places));
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
