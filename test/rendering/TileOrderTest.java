package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;

import org.junit.jupiter.api.Test;

class TileOrderTest {

  @Test
  void everyTileIsComputedOnceInWhateverOrder() {
    for (final int[] size : new int[][] {{1, 1}, {1, 9}, {7, 3}, {40, 30}}) {
      final Set<Integer> seen = new HashSet<>();
      for (final int tile : TileOrder.centreOutwards(size[0], size[1])) {
        assertTrue(tile >= 0 && tile < size[0] * size[1] && seen.add(tile));
      }
      assertEquals(size[0] * size[1], seen.size());
    }
  }
}
