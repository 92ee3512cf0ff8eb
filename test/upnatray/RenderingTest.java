package upnatray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RenderingTest {

  @Test
  void theStandardUsesAllCoresAndPlainColours() {
    assertEquals(Runtime.getRuntime().availableProcessors(), Rendering.STANDARD.threads());
    assertSame(Shading.PLAIN, Rendering.STANDARD.shading());
    assertSame(Progress.NONE, Rendering.STANDARD.progress());
    assertTrue(Progress.NONE.tileDone(0, 0, 16, 16));
  }

  @Test
  void changesOnePartAndKeepsTheOthers() {
    final Progress progress = (x, y, width, height) -> false;
    final Rendering rendering = Rendering.STANDARD.withThreads(3).withShading(Shading.FACING).withProgress(progress);
    assertEquals(new Rendering(3, Shading.FACING, progress), rendering);
    assertEquals(new Rendering(5, Shading.FACING, progress), rendering.withThreads(5));
    assertEquals(new Rendering(3, Shading.PLAIN, progress), rendering.withShading(Shading.PLAIN));
    assertEquals(new Rendering(3, Shading.FACING, Progress.NONE), rendering.withProgress(Progress.NONE));
  }

  @Test
  void rejectsWrongParts() {
    assertThrows(IllegalArgumentException.class, () -> Rendering.STANDARD.withThreads(0));
    assertThrows(IllegalArgumentException.class, () -> Rendering.STANDARD.withThreads(-3));
    assertThrows(IllegalArgumentException.class, () -> Rendering.STANDARD.withShading(null));
    assertThrows(IllegalArgumentException.class, () -> Rendering.STANDARD.withProgress(null));
  }
}
