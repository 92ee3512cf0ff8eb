package models;

import static arguments.Arguments.index;

import java.awt.Color;
import java.util.List;
import java.util.SplittableRandom;

/** The appearance of the triangles of a mesh: one for all, random colours, or each from a list. */
final class MeshAppearance {

  private final List<Appearance> appearances;
  /** For each triangle its appearance in the list; null: all have the first, or, if there is none, a random colour. */
  private final int[] ofTriangle;

  /**
   * Computed once, as it is needed for each pixel: the colour of all triangles, if they have one, and whether any is
   * textured.
   */
  private final boolean isTextured;
  private final boolean hasOneColor;
  private final int color;

  private MeshAppearance(final List<Appearance> appearances, final int[] ofTriangle) {
    this.appearances = appearances;
    this.ofTriangle = ofTriangle;
    this.isTextured = isTextured(appearances);
    this.hasOneColor = appearances.size() == 1;
    this.color = hasOneColor ? appearances.get(0).color().getRGB() : 0;
  }

  private static boolean isTextured(final List<Appearance> appearances) {
    for (final Appearance appearance : appearances) {
      if (appearance.texture() != null) {
        return true;
      }
    }
    return false;
  }

  /** One for all; null: random colours. */
  static MeshAppearance of(final Appearance appearance) {
    return new MeshAppearance(appearance == null ? List.of() : List.of(appearance), null);
  }

  /** One of a list for each triangle of arrays, by the numbers that the triangles had before some were left out. */
  static MeshAppearance of(final List<Appearance> appearances, final int[] given, final MeshArrays arrays) {
    for (int i = 0; i < given.length; i++) {
      index("ofTriangle[" + i + "]", appearances.size(), given[i]);
    }
    final int[] ofTriangle = new int[arrays.size()];
    for (int i = 0; i < ofTriangle.length; i++) {
      ofTriangle[i] = given[arrays.given(i)];
    }
    return new MeshAppearance(List.copyOf(appearances), ofTriangle);
  }

  /** The appearance of a triangle. The mixing of random colours is that of SplittableRandom's seed. */
  Appearance of(final int facet) {
    if (appearances.isEmpty()) {
      return Appearance.of(new Color(new SplittableRandom(facet).nextInt(1 << 24)));
    }
    return appearances.get(ofTriangle == null ? 0 : ofTriangle[facet]);
  }

  int argb(final int facet) {
    return hasOneColor ? color : of(facet).color().getRGB();
  }

  /** The one appearance of all triangles; null if they may differ. */
  Appearance common() {
    return hasOneColor ? appearances.get(0) : null;
  }

  boolean isTextured() {
    return isTextured;
  }
}
