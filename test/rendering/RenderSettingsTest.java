package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RenderSettingsTest {

  @Test
  void theStandardUsesAllCoresAndPlainColours() {
    assertEquals(Runtime.getRuntime().availableProcessors(), RenderSettings.STANDARD.threads());
    assertSame(Shading.PLAIN, RenderSettings.STANDARD.shading());
    assertSame(Progress.NONE, RenderSettings.STANDARD.progress());
    assertTrue(Progress.NONE.tileDone(0, 0, 16, 16));
  }

  @Test
  void changesOnePartAndKeepsTheOthers() {
    final Progress progress = (x, y, width, height) -> false;
    final RenderSettings rendering =
        RenderSettings.STANDARD.withThreads(3).withShading(Shading.FACING).withProgress(progress);
    assertEquals(new RenderSettings(3, Shading.FACING, progress), rendering);
    assertEquals(new RenderSettings(5, Shading.FACING, progress), rendering.withThreads(5));
    assertEquals(new RenderSettings(3, Shading.PLAIN, progress), rendering.withShading(Shading.PLAIN));
    assertEquals(new RenderSettings(3, Shading.FACING, Progress.NONE), rendering.withProgress(Progress.NONE));
  }

  @Test
  void rejectsWrongParts() {
    assertThrows(IllegalArgumentException.class, () -> RenderSettings.STANDARD.withThreads(0));
    assertThrows(IllegalArgumentException.class, () -> RenderSettings.STANDARD.withThreads(-3));
    assertThrows(IllegalArgumentException.class, () -> RenderSettings.STANDARD.withShading(null));
    assertThrows(IllegalArgumentException.class, () -> RenderSettings.STANDARD.withProgress(null));
  }
}
