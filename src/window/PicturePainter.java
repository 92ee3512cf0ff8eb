package window;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.TexturePaint;
import java.awt.image.BufferedImage;

/**
 * Paints a picture at a place, into an image that is then brought to the screen: scaling here is several times cheaper than
 * sending all the pixels to the screen to be scaled there. All edges are put on whole dots of the screen, so that
 * checkerboard, picture, grid and frame fit together on every screen, and parts painted later fit those painted before.
 */
final class PicturePainter {

  /** Size of a pixel, in dots of the screen, from which on there is a grid. */
  static final double GRID_FROM = 8;

  private static final int SQUARE = 8;
  private static final int LEAST_FRAME = 9;
  private static final Color GRID = new Color(128, 128, 128, 110);
  private static final BufferedImage SQUARES = new BufferedImage(2 * SQUARE, 2 * SQUARE, BufferedImage.TYPE_INT_RGB);

  static {
    for (int y = 0; y < 2 * SQUARE; y++) {
      for (int x = 0; x < 2 * SQUARE; x++) {
        SQUARES.setRGB(x, y, x / SQUARE == y / SQUARE ? 0xffffff : 0xd4d4d4);
      }
    }
  }

  private final Graphics2D g;
  private final int dots;
  private final int W;
  private final int H;
  private final Rectangle place;

  /**
   * A painter for a picture of W by H pixels.
   *
   * @param target what it paints on, in dots
   * @param clip the part to be painted, in dots
   * @param zoom where the picture is, in points
   * @param scale dots to a point
   */
  PicturePainter(final BufferedImage target, final Rectangle clip, final Zoom zoom, final double scale, final int W,
      final int H) {
    this.g = target.createGraphics();
    this.W = W;
    this.H = H;
    g.setClip(clip);
    dots = (int) Math.max(1, Math.round(scale));
    place = new Rectangle((int) Math.round(zoom.x() * scale), (int) Math.round(zoom.y() * scale),
        (int) Math.max(1, Math.round(W * zoom.scale() * scale)), (int) Math.max(1, Math.round(H * zoom.scale() * scale)));
  }

  /** Paints what is around the picture, and a checkerboard where it is, if there is one. */
  void paintGround(final Color around, final boolean hasPicture) {
    g.setColor(around);
    g.fill(g.getClip());
    if (hasPicture) {
      g.setPaint(new TexturePaint(SQUARES, new Rectangle(2 * SQUARE * dots, 2 * SQUARE * dots)));
      g.fill(place);
    }
  }

  /** Paints the pixels; smoothly, if there are more of them than dots and there is time for it. */
  void paint(final BufferedImage picture, final boolean inHaste) {
    g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, place.width < W && !inHaste
        ? RenderingHints.VALUE_INTERPOLATION_BILINEAR : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
    g.drawImage(picture, place.x, place.y, place.width, place.height, null);
  }

  /** Paints a grid between the pixels, if these are large. */
  void paintGrid() {
    if ((double) place.width / W < GRID_FROM) {
      return;
    }
    final Rectangle seen = place.intersection(g.getClipBounds());
    g.setColor(GRID);
    for (int i = column(seen.x); i <= column(seen.x + seen.width); i++) {
      g.fillRect(x(i), seen.y, 1, seen.height);
    }
    for (int i = row(seen.y); i <= row(seen.y + seen.height); i++) {
      g.fillRect(seen.x, y(i), seen.width, 1);
    }
  }

  /** Paints a frame about a pixel, black and white so that it is seen on any colour, and large enough to be seen. */
  void paintFrame(final Point pixel) {
    final int width = Math.max(LEAST_FRAME * dots, x(pixel.x + 1) - x(pixel.x));
    final int height = Math.max(LEAST_FRAME * dots, y(pixel.y + 1) - y(pixel.y));
    final int x = (x(pixel.x) + x(pixel.x + 1) - width) / 2, y = (y(pixel.y) + y(pixel.y + 1) - height) / 2;
    g.setStroke(new BasicStroke(3 * dots));
    g.setColor(Color.BLACK);
    g.drawRect(x, y, width, height);
    g.setStroke(new BasicStroke(dots));
    g.setColor(Color.WHITE);
    g.drawRect(x, y, width, height);
  }

  /** First dot of a column of pixels. */
  private int x(final int column) {
    return place.x + (int) Math.round((double) column * place.width / W);
  }

  private int y(final int row) {
    return place.y + (int) Math.round((double) row * place.height / H);
  }

  private int column(final int x) {
    return (int) ((double) (x - place.x) * W / place.width);
  }

  private int row(final int y) {
    return (int) ((double) (y - place.y) * H / place.height);
  }

  void dispose() {
    g.dispose();
  }
}
