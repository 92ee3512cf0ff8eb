package models;

import java.util.AbstractList;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * The triangles of a mesh as objects, in the order of its facets. Each is created when first requested, and is the same
 * object from then on, for all threads.
 */
final class MeshTriangles extends AbstractList<Triangle> {

  private final MeshSurface surface;
  private final MeshAppearance appearance;
  private final AtomicReference<AtomicReferenceArray<Triangle>> made = new AtomicReference<>();

  MeshTriangles(final MeshSurface surface, final MeshAppearance appearance) {
    this.surface = surface;
    this.appearance = appearance;
  }

  @Override
  public Triangle get(final int index) {
    return of(Objects.checkIndex(index, size()));
  }

  @Override
  public int size() {
    return surface.tree().size();
  }

  /** The triangle of a facet. */
  Triangle of(final int facet) {
    AtomicReferenceArray<Triangle> triangles = made.get();
    if (triangles == null) {
      made.compareAndSet(null, new AtomicReferenceArray<>(size()));
      triangles = made.get();
    }
    final Triangle known = triangles.get(facet);
    if (known != null) {
      return known;
    }
    triangles.compareAndSet(facet, null, surface.triangle(facet, appearance.of(facet)));
    return triangles.get(facet);
  }

  /** The facet of a triangle; −1 if it is none of these. */
  int facetOf(final Triangle triangle) {
    final AtomicReferenceArray<Triangle> triangles = made.get();
    for (int facet = 0; triangles != null && triangle != null && facet < triangles.length(); facet++) {
      if (triangles.get(facet) == triangle) {
        return facet;
      }
    }
    return -1;
  }

  MeshSurface surface() {
    return surface;
  }
}
