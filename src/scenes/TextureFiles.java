package scenes;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;

import arguments.Messages;
import materials.Texture;
import meshes.TextureFile;

/** The textures of a scene file: each file is read once. */
final class TextureFiles {

  private final MeshFiles files;
  private final Problems problems;
  /** The texture of each file; null for one that cannot be used. */
  private final Map<Path, Texture> textures = new HashMap<>();

  TextureFiles(final MeshFiles files, final Problems problems) {
    this.files = files;
    this.problems = problems;
  }

  /** The texture that an element names; null, and reported, if there is none. */
  Texture read(final String name, final int offset) {
    final Path file = files.existing(name, offset, "noTexture");
    if (file == null) {
      return null;
    }
    if (!textures.containsKey(file)) {
      try {
        textures.put(file, TextureFile.read(file));
      } catch (final TextureFile.UnusableException unusable) {
        textures.put(file, null);
        problems.error(offset, "badTexture", Messages.quote(name), unusable.getMessage());
      }
    }
    return textures.get(file);
  }

  /** The files of the textures found so far. */
  Set<Path> paths() {
    return textures.keySet();
  }
}
