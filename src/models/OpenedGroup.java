package models;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

/** The objects of a group and of all nested groups, in the order in which they are tested, each once. */
final class OpenedGroup {

  private final List<Object3D> members = new ArrayList<>();
  private final Set<Object3D> seen = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Deque<Object3D> open = new ArrayDeque<>();

  /** The members of a group; without recursion, since thousands of groups may be nested. */
  static List<Object3D> membersOf(final Group3D group) {
    final OpenedGroup opened = new OpenedGroup();
    opened.open.push(group);
    while (!opened.open.isEmpty()) {
      final Object3D object = opened.open.pop();
      if (opened.seen.add(object)) {
        object.addTo(opened);
      }
    }
    return Collections.unmodifiableList(opened.members);
  }

  /** Adds an object that is not a group. */
  void add(final Object3D object) {
    members.add(object);
  }

  /** Adds what a group contains. */
  void addAll(final List<Object3D> parts) {
    for (int i = parts.size() - 1; i >= 0; i--) {
      open.push(parts.get(i));
    }
  }
}
