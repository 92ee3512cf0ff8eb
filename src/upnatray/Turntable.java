package upnatray;

import java.nio.file.Path;
import java.util.Objects;

import view.Camera;

/**
 * An animation in which the camera goes once around the point that it looks at: N pictures, numbered from 0, picture k after
 * k / N of a turn.
 *
 * @param pictures N
 * @param seconds how long a turn takes
 * @param first number of the first picture to be rendered
 * @param last number of the last picture to be rendered
 * @param again whether existing pictures are rendered again
 */
record Turntable(int pictures, double seconds, int first, int last, boolean again) {

  /** Limits of the number of pictures. */
  static final int FEWEST = 2;
  static final int MOST = 10_000;

  /** Pictures per second by default. */
  private static final int STANDARD_RATE = 12;

  /** Limits of the seconds for which a picture is shown: browsers slow down shorter ones, PNG cannot express longer ones. */
  static final double SHORTEST = 0.01;
  static final double LONGEST = 65_535;

  /** Duration of a turn by default, in seconds. */
  static double standardSeconds(final int pictures) {
    return (double) pictures / STANDARD_RATE;
  }

  /** Whether all pictures are to be rendered, so that the animated picture can be made of them. */
  boolean isWhole() {
    return first == 0 && last == pictures - 1;
  }

  /** The camera of picture k; the first is the camera as it is. */
  Camera camera(final Camera camera, final int k) {
    return k == 0 ? camera : camera.turned(360.0 * k / pictures);
  }

  /** The file of picture k, beside the animated picture: NAME-007.png. */
  Path file(final Path animated, final int k) {
    final String name = Objects.toString(animated.getFileName(), "").replaceFirst("(?i)\\.png$", "");
    final int digits = Math.max(3, Integer.toString(pictures - 1).length());
    return animated.resolveSibling(name + "-" + "0".repeat(digits - Integer.toString(k).length()) + k + ".png");
  }
}
