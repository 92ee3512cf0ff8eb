package diagnostics;

import java.util.Collection;
import java.util.Locale;

import arguments.Messages;

/**
 * The known name that was probably meant by an unknown one. Names are compared by the number of letters to insert, to
 * delete, to replace or to swap with their neighbour (optimal string alignment), capitals aside.
 */
public final class Suggestion {

  /** Longer names, and longer lists of names, are not compared. */
  private static final int LONGEST = 40;
  private static final int MOST = 1000;

  private Suggestion() {
  }

  /**
   * The known name nearest to what was found.
   *
   * @param found the name that was found
   * @param known the known names
   * @return the nearest; null if none is near: up to a third of the letters may be wrong
   */
  public static String of(final String found, final Collection<String> known) {
    String nearest = null;
    double least = Double.POSITIVE_INFINITY;
    for (final String name : known) {
      final int allowed = Math.max(1, Math.min(found.length(), name.length()) / 3);
      if (Math.abs(found.length() - name.length()) <= allowed && !found.equals(name)) {
        final int distance = distance(found.toLowerCase(Locale.ROOT), name.toLowerCase(Locale.ROOT));
        if (distance <= allowed && distance < Math.min(least, name.length())) {
          nearest = name;
          least = distance;
        }
      }
    }
    return nearest;
  }

  /**
   * The question whether a known name was meant, to end a message.
   *
   * @param found the name that was found
   * @param known the known names
   * @return the question after a blank; empty if no known name is near, or if there are too many
   */
  public static String question(final String found, final Collection<String> known) {
    final String name = found.length() > LONGEST || known.size() > MOST ? null : of(found, known);
    return name == null ? "" : " " + Messages.text("diagnostics.didYouMean", name);
  }

  static int distance(final String a, final String b) {
    int[] beforeLast = new int[b.length() + 1];
    int[] last = new int[b.length() + 1];
    for (int j = 0; j <= b.length(); j++) {
      last[j] = j;
    }
    for (int i = 1; i <= a.length(); i++) {
      final int[] row = new int[b.length() + 1];
      row[0] = i;
      for (int j = 1; j <= b.length(); j++) {
        final int replaced = last[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
        row[j] = Math.min(replaced, Math.min(last[j], row[j - 1]) + 1);
        if (i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1)) {
          row[j] = Math.min(row[j], beforeLast[j - 2] + 1);
        }
      }
      beforeLast = last;
      last = row;
    }
    return last[b.length()];
  }
}
