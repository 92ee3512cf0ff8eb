package window;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.TexturePaint;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;

/**
 * Paints a zoomed picture into an off-screen buffer in device pixels: scaling in memory is several times cheaper than having
 * the screen scale the whole picture. All edges are rounded to device pixels, so that checkerboard, picture, grid and frame
 * coincide at every scale factor, and separately painted regions join without seams.
 */
final class PicturePainter {

  /** Size of a picture pixel, in device pixels, from which a grid is drawn. */
  static final double MIN_GRID_SIZE = 8;

  private static final int SQUARE = 8;
  private static final int MIN_FRAME = 9;
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
  private final int unit;
  private final int W;
  private final int H;
  private final Rectangle place;

  /**
   * A painter for a picture.
   *
   * @param target the buffer to paint into
   * @param clip the region to be painted, in device pixels
   * @param zoom position and scale of the picture, in component coordinates
   * @param scale device pixels per unit of the component's coordinates
   * @param size size of the picture in pixels
   */
  PicturePainter(final BufferedImage target, final Rectangle clip, final Zoom zoom, final double scale,
      final Dimension size) {
    this.g = target.createGraphics();
    this.W = size.width;
    this.H = size.height;
    g.setClip(clip);
    unit = (int) Math.max(1, Math.round(scale));
    place = new Rectangle((int) Math.round(zoom.x() * scale), (int) Math.round(zoom.y() * scale),
        (int) Math.max(1, Math.round(W * zoom.scale() * scale)), (int) Math.max(1, Math.round(H * zoom.scale() * scale)));
  }

  /** Paints the surroundings, and a checkerboard behind the picture if there is one. */
  void paintGround(final Color around, final boolean hasPicture) {
    g.setColor(around);
    g.fill(g.getClip());
    if (hasPicture) {
      g.setPaint(new TexturePaint(SQUARES, new Rectangle(2 * SQUARE * unit, 2 * SQUARE * unit)));
      g.fill(place);
    }
  }

  /** Paints the pixels, with interpolation if they are smaller than device pixels and speed does not matter. */
  void paint(final BufferedImage picture, final boolean fast) {
    g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, place.width < W && !fast
        ? RenderingHints.VALUE_INTERPOLATION_BILINEAR : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
    g.drawImage(picture, place.x, place.y, place.width, place.height, null);
  }

  /** Paints a grid between the pixels, if they are large enough. */
  void paintGrid() {
    if ((double) place.width / W < MIN_GRID_SIZE) {
      return;
    }
    final Rectangle visible = place.intersection(g.getClipBounds());
    g.setColor(GRID);
    for (int i = column(visible.x); i <= column(visible.x + visible.width); i++) {
      g.fillRect(x(i), visible.y, 1, visible.height);
    }
    for (int i = row(visible.y); i <= row(visible.y + visible.height); i++) {
      g.fillRect(visible.x, y(i), visible.width, 1);
    }
  }

  /** Paints a frame around a pixel: black and white, so that it stands out on any colour, with a minimum size. */
  void paintFrame(final Point pixel) {
    final int width = Math.max(MIN_FRAME * unit, x(pixel.x + 1) - x(pixel.x));
    final int height = Math.max(MIN_FRAME * unit, y(pixel.y + 1) - y(pixel.y));
    final int x = (x(pixel.x) + x(pixel.x + 1) - width) / 2, y = (y(pixel.y) + y(pixel.y + 1) - height) / 2;
    g.setStroke(new BasicStroke(3 * unit));
    g.setColor(Color.BLACK);
    g.drawRect(x, y, width, height);
    g.setStroke(new BasicStroke(unit));
    g.setColor(Color.WHITE);
    g.drawRect(x, y, width, height);
  }

  /** Paints projected rays, thin where an object hides them; a white border makes them stand out on any colour. */
  void paintRays(final RayOverlay rays) {
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    final AffineTransform toDevice = AffineTransform.getTranslateInstance(place.x, place.y);
    toDevice.scale((double) place.width / W, (double) place.height / H);
    for (final boolean border : new boolean[] {true, false}) {
      for (final RayOverlay.Part part : rays.parts()) {
        if (part.isVisible() || !border) {
          g.setColor(border ? Color.WHITE : part.colour());
          g.setStroke(new BasicStroke(unit * (border ? 4 : part.isVisible() ? 2.2f : 0.8f)));
          g.draw(part.path().createTransformedShape(toDevice));
        }
      }
    }
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
  }

  /** First device pixel of a column of the picture. */
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
