package window;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;

/**
 * Where a picture lies in a component: how many points of the component a pixel of the picture takes, and where the
 * picture's upper left corner is.
 *
 * @param scale points to a pixel, &gt; 0
 * @param x the corner's x in the component
 * @param y the corner's y in the component
 */
record Zoom(double scale, double x, double y) {

  private static final double LARGEST = 64;
  private static final double SMALLEST = 1.0 / 64;

  /** The whole picture in the middle of a component. */
  static Zoom fit(final int W, final int H, final int width, final int height) {
    return centred(Math.max(SMALLEST, Math.min(LARGEST, Math.min((double) width / W, (double) height / H))),
        W, H, width, height);
  }

  /** The middle of the picture in the middle of a component. */
  static Zoom centred(final double scale, final int W, final int H, final int width, final int height) {
    return new Zoom(scale, 0.5 * (width - W * scale), 0.5 * (height - H * scale));
  }

  /** The same with another scale, so that what is at a place stays there. */
  Zoom about(final Point2D place, final double factor) {
    final double wanted = Math.max(SMALLEST, Math.min(LARGEST, scale * factor)), k = wanted / scale;
    return new Zoom(wanted, place.getX() - k * (place.getX() - x), place.getY() - k * (place.getY() - y));
  }

  /** The same with the picture moved. */
  Zoom moved(final double dx, final double dy) {
    return new Zoom(scale, x + dx, y + dy);
  }

  /** The same, moved so that a pixel is in the middle of a component. */
  Zoom centredOn(final Point pixel, final int width, final int height) {
    return new Zoom(scale, 0.5 * width - (pixel.x + 0.5) * scale, 0.5 * height - (pixel.y + 0.5) * scale);
  }

  /** The pixel at a place, perhaps outside the picture. */
  Point pixelAt(final Point2D place) {
    return new Point((int) Math.floor((place.getX() - x) / scale), (int) Math.floor((place.getY() - y) / scale));
  }

  /** The least rectangle of whole points that contains some pixels. */
  Rectangle onScreen(final Rectangle pixels) {
    final int left = (int) Math.floor(x + pixels.x * scale), top = (int) Math.floor(y + pixels.y * scale);
    final int right = (int) Math.ceil(x + (pixels.x + pixels.width) * scale),
        bottom = (int) Math.ceil(y + (pixels.y + pixels.height) * scale);
    return new Rectangle(left, top, right - left, bottom - top);
  }

  /** The least rectangle of whole pixels that contains a part of the component. */
  Rectangle inPicture(final Rectangle points) {
    final int left = (int) Math.floor((points.x - x) / scale), top = (int) Math.floor((points.y - y) / scale);
    final int right = (int) Math.ceil((points.x + points.width - x) / scale),
        bottom = (int) Math.ceil((points.y + points.height - y) / scale);
    return new Rectangle(left, top, right - left, bottom - top);
  }
}
