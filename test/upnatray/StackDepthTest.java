package upnatray;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rendering.RenderSettings;

/** Who debugs a shape sees the whole way of a pixel at a glance. */
class StackDepthTest {

  /** Methods from {@code Main.main} to the intersection of a shape, both included. */
  private static final int MOST = 12;

  /** Where the shapes are asked; a shape's own method may have been compiled into it, and then is never seen. */
  private static final String ASKING = "rendering.PixelLoop.closestHit";

  @Test
  void fewCallsLeadFromMainToAShape(@TempDir final Path folder) throws Exception {
    final Path picture = folder.resolve("shapes.png");
    final String[] commandLine = {"scenes/shapes.xml", "--width", "120", "-o", picture.toString()};
    System.setProperty(RenderSettings.PIXEL_LOOP, "true");
    List<String> calls = List.of();
    try {
      for (int pictures = 0; pictures < 20 && calls.isEmpty(); pictures++) {
        final Thread main = new Thread(() -> Main.main(commandLine));
        main.start();
        while (main.isAlive() && calls.isEmpty()) {
          calls = calls(main.getStackTrace());
        }
        main.join();
        assertTrue(Files.size(picture) > 0);
      }
    } finally {
      System.clearProperty(RenderSettings.PIXEL_LOOP);
    }
    assertTrue(calls.contains("upnatray.Main.main"), calls.toString());
    assertTrue(calls.indexOf("upnatray.Main.main") + 2 <= MOST, calls.toString());
  }

  /** The calls that led to where shapes are asked, the last first; empty if the thread is somewhere else. */
  private static List<String> calls(final StackTraceElement[] stack) {
    final List<String> calls = new ArrayList<>();
    for (final StackTraceElement call : stack) {
      final String name = call.getClassName() + "." + call.getMethodName();
      if (!calls.isEmpty() || name.equals(ASKING)) {
        calls.add(name);
      }
    }
    return calls;
  }
}
