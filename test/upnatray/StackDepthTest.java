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

  @Test
  void fewCallsLeadFromMainToAShape(@TempDir final Path folder) throws Exception {
    final Path picture = folder.resolve("shapes.png");
    final String[] commandLine = {"scenes/shapes.xml", "--width", "120", "-o", picture.toString()};
    System.setProperty(RenderSettings.PIXEL_LOOP, "true");
    List<String> calls = List.of();
    try {
      while (calls.isEmpty()) {
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
    assertTrue(calls.indexOf("upnatray.Main.main") < MOST, calls.toString());
  }

  /** The calls that led to a sphere's intersection, the last first; empty if the thread is somewhere else. */
  private static List<String> calls(final StackTraceElement[] stack) {
    final List<String> calls = new ArrayList<>();
    for (final StackTraceElement call : stack) {
      final String name = call.getClassName() + "." + call.getMethodName();
      if (!calls.isEmpty() || name.equals("models.Sphere.intersectionWith")) {
        calls.add(name);
      }
    }
    return calls;
  }
}
