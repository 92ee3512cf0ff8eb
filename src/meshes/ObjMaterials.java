package meshes;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The materials that a mesh file refers to: their files, and the names that its facets use. */
final class ObjMaterials {

  /**
   * A name in a file.
   *
   * @param text the name
   * @param line where it occurs first
   */
  record Name(String text, int line) {
  }

  private final List<Name> libraries = new ArrayList<>();
  private final List<Name> used = new ArrayList<>();
  private final Map<String, Integer> numbers = new HashMap<>();

  /** Adds the files of a statement {@code mtllib}. */
  void library(final String names, final int line) {
    libraries.add(new Name(names, line));
  }

  /** Number of a material, from 0: the same for the same name. */
  int use(final String name, final int line) {
    final Integer known = numbers.putIfAbsent(name, used.size());
    if (known != null) {
      return known;
    }
    used.add(new Name(name, line));
    return used.size() - 1;
  }

  /** The text after each {@code mtllib}. */
  List<Name> libraries() {
    return libraries;
  }

  /** The materials that facets use, by their numbers. */
  List<Name> used() {
    return used;
  }
}
