package window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;

class WindowPlacementTest {

  private static final Rectangle LAPTOP = new Rectangle(0, 0, 1024, 570);
  private static final Rectangle PROJECTOR = new Rectangle(-1280, 100, 1280, 720);
  private static final Rectangle DEFAULT = new Rectangle(0, 0, 1180, 760);

  @Test
  void aNewWindowIsCentredAndFitsTheScreen() {
    assertEquals(LAPTOP, WindowPlacement.place(DEFAULT, false, List.of(LAPTOP)));
    assertEquals(new Rectangle(370, 160, 1180, 760),
        WindowPlacement.place(DEFAULT, false, List.of(new Rectangle(0, 0, 1920, 1080))));
  }

  @Test
  void aWindowReturnsToItsPlace() {
    final Rectangle there = new Rectangle(100, 50, 600, 400), left = new Rectangle(-900, 200, 600, 400);
    assertEquals(there, WindowPlacement.place(there, true, List.of(LAPTOP, PROJECTOR)));
    assertEquals(left, WindowPlacement.place(left, true, List.of(LAPTOP, PROJECTOR)));
  }

  @Test
  void aWindowOfAScreenThatIsGoneIsCentred() {
    final Rectangle left = new Rectangle(-900, 200, 600, 400);
    assertEquals(new Rectangle(212, 85, 600, 400), WindowPlacement.place(left, true, List.of(LAPTOP)));
  }

  @Test
  void aWindowAcrossTwoScreensGoesToTheOneWithTheLargerPart() {
    assertEquals(new Rectangle(-600, 150, 600, 400),
        WindowPlacement.place(new Rectangle(-500, 150, 600, 400), true, List.of(LAPTOP, PROJECTOR)));
  }

  @Test
  void everyWindowLiesWithinOneScreen() {
    final long seed = 15;
    final Random random = new Random(seed);
    for (int i = 0; i < 20_000; i++) {
      final Rectangle wanted = new Rectangle(random.nextInt(8000) - 4000, random.nextInt(8000) - 4000,
          1 + random.nextInt(4000), 1 + random.nextInt(4000));
      final Rectangle placed = WindowPlacement.place(wanted, random.nextBoolean(), List.of(LAPTOP, PROJECTOR));
      assertTrue(LAPTOP.contains(placed) || PROJECTOR.contains(placed), () -> "seed " + seed + ": " + wanted + placed);
    }
  }

  /** At 420 points the picture has more than half, below 340 points the inspector gives way altogether. */
  @Test
  void thePictureHasPriorityInASmallWindow() {
    assertEquals(760, PrioritySplit.firstSize(1180, 420, 140));
    assertEquals(244, PrioritySplit.firstSize(420, 420, 140));
    assertEquals(320, PrioritySplit.firstSize(320, 420, 140));
    assertEquals(0, PrioritySplit.firstSize(0, 420, 140));
  }
}
