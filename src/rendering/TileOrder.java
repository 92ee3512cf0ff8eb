package rendering;

/** The order in which tiles are computed if there is an observer: from the centre outwards. */
final class TileOrder {

  private TileOrder() {
  }

  /**
   * The numbers of the tiles, row by row from 0, sorted by their distance from the centre in whole tiles.
   *
   * @param across number of columns of tiles
   * @param down number of rows of tiles
   */
  static int[] centreOutwards(final int across, final int down) {
    final int[] first = new int[across + down + 2];
    for (int tile = 0; tile < across * down; tile++) {
      first[distance(tile, across, down) + 1]++;
    }
    for (int i = 1; i < first.length; i++) {
      first[i] += first[i - 1];
    }
    final int[] order = new int[across * down];
    for (int tile = 0; tile < order.length; tile++) {
      order[first[distance(tile, across, down)]++] = tile;
    }
    return order;
  }

  private static int distance(final int tile, final int across, final int down) {
    final int x = 2 * (tile % across) + 1 - across, y = 2 * (tile / across) + 1 - down;
    return (int) (0.5 * Math.sqrt((double) x * x + (double) y * y));
  }
}
