package scenes;

import java.awt.Color;

import arguments.Messages;

/**
 * Colours of scene files: sRGB triples from 0 to 1 or from 0 to 255, without any indication which.
 *
 * <p>If a number exceeds 1, all three are in the range up to 255. Readers that decide number by number see another colour
 * in a triple with numbers on both sides of 1, so that causes a warning.
 */
final class Colours {

  private static final Range BYTE = new Range(0, true, 255, true);

  private final Values values;

  Colours(final Values values) {
    this.values = values;
  }

  /** A required colour; null if it is missing or invalid. */
  Color required(final Element element, final String name) {
    final Element value = values.required(element, name, Expected.COLOUR);
    return value == null ? null : of(value);
  }

  /** The colour of a value; null if it is invalid. */
  Color of(final Element value) {
    final float[] triple = values.triple(value, BYTE);
    if (triple == null) {
      return null;
    }
    final boolean bytes = triple[0] > 1 || triple[1] > 1 || triple[2] > 1;
    if (bytes && (isFraction(triple[0]) || isFraction(triple[1]) || isFraction(triple[2]))) {
      values.problems().warning(value.valueOffset(), "mixedColour", value.name(), Messages.quote(value.text()));
    }
    return colour(triple, bytes ? 1 : 255);
  }

  private static boolean isFraction(final float component) {
    return component > 0 && component <= 1;
  }

  /** The colour of three numbers, scaled by a factor to 0 … 255; larger ones count as 255. */
  static Color colour(final float[] triple, final double factor) {
    return new Color(component(triple[0] * factor), component(triple[1] * factor), component(triple[2] * factor));
  }

  private static int component(final double value) {
    return (int) Math.min(255, Math.floor(value + 0.5));
  }
}
