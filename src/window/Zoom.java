package window;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;

/**
 * Scale and position of a picture in a component.
 *
 * @param scale component units per pixel of the picture, &gt; 0
 * @param x x of the picture's upper left corner in the component
 * @param y y of that corner
 */
record Zoom(double scale, double x, double y) {

  private static final double MAX_SCALE = 64;
  private static final double MIN_SCALE = 1.0 / 64;

  /** The whole picture, centred in a component. */
  static Zoom fit(final int W, final int H, final int width, final int height) {
    return centred(Math.max(MIN_SCALE, Math.min(MAX_SCALE, Math.min((double) width / W, (double) height / H))),
        W, H, width, height);
  }

  /** The picture centred in a component at a given scale. */
  static Zoom centred(final double scale, final int W, final int H, final int width, final int height) {
    return new Zoom(scale, 0.5 * (width - W * scale), 0.5 * (height - H * scale));
  }

  /** This zoom scaled by a factor about a fixed point of the component. */
  Zoom about(final Point2D fixed, final double factor) {
    final double wanted = Math.max(MIN_SCALE, Math.min(MAX_SCALE, scale * factor)), k = wanted / scale;
    return new Zoom(wanted, fixed.getX() - k * (fixed.getX() - x), fixed.getY() - k * (fixed.getY() - y));
  }

  /** This zoom translated. */
  Zoom moved(final double dx, final double dy) {
    return new Zoom(scale, x + dx, y + dy);
  }

  /** This zoom translated so that a pixel is at the centre of a component. */
  Zoom centredOn(final Point pixel, final int width, final int height) {
    return new Zoom(scale, 0.5 * width - (pixel.x + 0.5) * scale, 0.5 * height - (pixel.y + 0.5) * scale);
  }

  /** The pixel at a point of the component, possibly outside the picture. */
  Point pixelAt(final Point2D place) {
    return new Point((int) Math.floor((place.getX() - x) / scale), (int) Math.floor((place.getY() - y) / scale));
  }

  /** The smallest integer rectangle of the component that contains some pixels. */
  Rectangle onScreen(final Rectangle pixels) {
    final int left = (int) Math.floor(x + pixels.x * scale), top = (int) Math.floor(y + pixels.y * scale);
    final int right = (int) Math.ceil(x + (pixels.x + pixels.width) * scale),
        bottom = (int) Math.ceil(y + (pixels.y + pixels.height) * scale);
    return new Rectangle(left, top, right - left, bottom - top);
  }
}
