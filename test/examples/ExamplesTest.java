package examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The generated files are up to date, and show what their comments say. */
class ExamplesTest {

  private static final boolean WRITE = Boolean.getBoolean("examples.write");

  @ParameterizedTest
  @EnumSource
  void fileIsWhatItsProgramWrites(final ExampleFile file) throws IOException {
    if (WRITE) {
      file.write();
    }
    assertTrue(file.fromProgram().equals(file.fromFile()), file.path() + " differs from what its program writes");
  }

  /** Each edge of a facet occurs once in the other direction: no holes, no overlaps, one orientation. */
  @Test
  void knotIsClosedAndTurnedOutwards() throws IOException {
    final List<double[]> points = new ArrayList<>();
    final Set<List<Integer>> sides = new HashSet<>();
    double volume = 0;
    for (final String line : ExampleFile.KNOT.fromFile().split("\n")) {
      final String[] words = line.split(" ");
      if (words[0].equals("v")) {
        points.add(Stream.of(words).skip(1).mapToDouble(Double::parseDouble).toArray());
      } else if (words[0].equals("f")) {
        final int[] corners = Stream.of(words).skip(1).mapToInt(Integer::parseInt).toArray();
        for (int i = 0; i < corners.length; i++) {
          assertTrue(sides.add(List.of(corners[i], corners[(i + 1) % corners.length])), line);
        }
        volume += sixfoldVolume(points.get(corners[0] - 1), points.get(corners[1] - 1), points.get(corners[2] - 1));
      }
    }
    assertTrue(sides.size() > 50_000, () -> sides.size() + " sides");
    sides.forEach(side -> assertTrue(sides.contains(List.of(side.get(1), side.get(0))), () -> "side " + side + " is open"));
    assertTrue(volume > 0, "inside out");
  }

  /** Of the tetrahedron between the origin and three points; positive if they go round counter-clockwise from outside. */
  private static double sixfoldVolume(final double[] a, final double[] b, final double[] c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  @Test
  void defaultSceneHasEveryShape() throws IOException {
    final Set<String> types = new HashSet<>();
    final String scene = Files.readString(Path.of("scenes", "shapes.xml"));
    Pattern.compile("<model id=\"[^\"]*\" type=\"(\\w+)\">").matcher(scene).results()
        .forEach(match -> types.add(match.group(1)));
    assertEquals(Set.of("sphere", "box", "plane", "cylinder", "capsule", "torus", "ellipsoid", "mesh"), types);
  }

  @Test
  void theBallHasTheImageThatItsProgramDraws() throws IOException {
    final BufferedImage drawn = BeachBall.image(), file = ImageIO.read(BeachBall.FILE.toFile());
    assertEquals(drawn.getWidth() * drawn.getHeight(), file.getWidth() * file.getHeight());
    for (int i = 0; i < drawn.getWidth() * drawn.getHeight(); i++) {
      assertEquals(drawn.getRGB(i % drawn.getWidth(), i / drawn.getWidth()), file.getRGB(i % drawn.getWidth(),
          i / drawn.getWidth()));
    }
  }

  @Test
  void numbersAreShort() {
    assertEquals("-0.5 10 0", Numbers.triple(-0.5, 9.9999, -0.0001));
    assertEquals("100 2 -3.125", Numbers.triple(100, 2, -3.125));
  }
}
