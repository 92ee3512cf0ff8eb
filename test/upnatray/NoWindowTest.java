package upnatray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The command line without a display. */
class NoWindowTest {

  private static final String SCENE = Path.of("scenes", "shapes.xml").toAbsolutePath().toString();

  @TempDir
  private Path folder;

  @Test
  void nothingOfTheWindowIsLoadedForAPngFile() throws Exception {
    final CommandLine.Result result = new CommandLine(folder).with("-verbose:class")
        .run(SCENE, "--width", "32", "-o", "a.png");
    assertEquals(0, result.status(), result.err());
    assertTrue(result.out().contains(" rendering.TileRenderer "), "the classes are listed");
    for (final String other : List.of(" window.", " inspection.", " javax.swing.", " com.formdev.", " java.util.prefs.")) {
      assertFalse(result.out().contains(other), other);
    }
  }

  @Test
  void aWindowThatMustBeThereNeedsADisplay() throws Exception {
    final CommandLine.Result result = new CommandLine(folder).run(SCENE, "--window");
    assertEquals(2, result.status());
    assertTrue(result.err().contains("--window needs a display"), result.err());
  }

  @Test
  void aViewIsChosenByItsName() throws Exception {
    final CommandLine.Result depth = new CommandLine(folder).run(SCENE, "--width", "32", "-o", "a.png", "--view", "depth");
    assertEquals(0, depth.status(), depth.err());
    assertTrue(depth.out().contains("depth: white "), depth.out());
    final CommandLine.Result wrong = new CommandLine(folder).run(SCENE, "--view", "deep");
    assertEquals(2, wrong.status());
    assertTrue(wrong.err().contains("colour, normals, depth, object, cost"), wrong.err());
  }
}
