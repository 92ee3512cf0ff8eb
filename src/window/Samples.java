package window;

import java.util.List;

import arguments.Messages;

/**
 * How many rays a pixel gets.
 *
 * @param K square root of the number of rays, at least 1
 * @param atEdges whether only pixels that an edge may cross get them, and the others one
 */
record Samples(int K, boolean atEdges) {

  static final Samples ONE = new Samples(1, false);

  /** What can be chosen. */
  static final List<Samples> CHOICES = List.of(ONE, new Samples(2, false), new Samples(3, false), new Samples(4, false),
      new Samples(8, false), new Samples(4, true), new Samples(8, true));

  /** The key of its menu item, in the notation of {@link javax.swing.KeyStroke#getKeyStroke(String)}. */
  String key() {
    return (atEdges ? "ctrl shift alt " : "shift alt ") + K;
  }

  @Override
  public String toString() {
    return K == 1 ? "1" : Messages.text(atEdges ? "window.samples.atEdges" : "window.samples.all", K);
  }
}
