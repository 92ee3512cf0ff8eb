package window;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;

import arguments.Messages;

/** Shows a picture at any zoom: a checkerboard where it is transparent, a grid between large pixels, a pinned pixel. */
final class PictureView extends Drawing {

  private static final long serialVersionUID = 1L;

  /** Is told what the user points at; pixels count from the upper left corner. */
  interface PixelListener {

    /** The pointer is at a pixel; null if it is at none. */
    void hovered(Point pixel);

    /** A pixel was chosen. */
    void pinned(Point pixel);
  }

  private final transient PixelListener listener;
  private transient BufferedImage picture = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB);
  private transient BufferedImage overlay;
  private transient BufferedImage dots;
  private transient Zoom zoom = new Zoom(1, 0, 0);
  private boolean fitting = true;
  private boolean hasPicture;
  private boolean filling;
  private Point pinned;
  private double secondsToPaint;

  PictureView(final PixelListener listener) {
    super("picture.name");
    this.listener = listener;
    setName("picture");
    setFocusable(true);
    setOpaque(true);
    setPreferredSize(new Dimension(640, 480));
    setCursor(Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR));
    getAccessibleContext().setAccessibleDescription(Messages.text("window.picture.tip"));
    final PictureMouse mouse = new PictureMouse(this);
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
    addMouseWheelListener(mouse);
    addComponentListener(new ComponentAdapter() {
      @Override
      public void componentResized(final ComponentEvent event) {
        changed();
      }
    });
  }

  /** Shows nothing. */
  void clear() {
    hasPicture = false;
    overlay = null;
    changed();
  }

  /** Shows another picture; of the same size it keeps zoom and pinned pixel. */
  void setPicture(final BufferedImage next) {
    final boolean sameSize = next.getWidth() == picture.getWidth() && next.getHeight() == picture.getHeight();
    picture = next;
    hasPicture = true;
    overlay = null;
    if (!sameSize) {
      fitting = true;
      pinned = null;
    }
    changed();
  }

  private void changed() {
    firePropertyChange("zoom", -1.0, zoom().scale());
    repaint();
  }

  /** Whether the picture is still coming into being: then it is painted as quickly as possible. */
  void setFilling(final boolean next) {
    filling = next;
    repaint();
  }

  BufferedImage picture() {
    return picture;
  }

  boolean hasPicture() {
    return hasPicture;
  }

  /** Shows something over the picture, such as the mask of a comparison; null for nothing. */
  void setOverlay(final BufferedImage mask) {
    overlay = mask;
    repaint();
  }

  boolean hasOverlay() {
    return overlay != null;
  }

  /** Some pixels have changed. */
  void repaintPixels(final Rectangle pixels) {
    if (!pixels.isEmpty()) {
      final Rectangle dirty = zoom().onScreen(pixels);
      dirty.grow(2, 2);
      repaint(dirty);
    }
  }

  /** Dots of the screen to a point. */
  private double dotsToAPoint() {
    return getGraphicsConfiguration() == null ? 1 : getGraphicsConfiguration().getDefaultTransform().getScaleX();
  }

  Zoom zoom() {
    if (fitting) {
      zoom = Zoom.fit(picture.getWidth(), picture.getHeight(), getWidth(), getHeight());
    }
    return zoom;
  }

  private void setZoom(final Zoom next) {
    fitting = false;
    zoom = next;
    changed();
  }

  /** How many dots of the screen a pixel has. */
  double magnification() {
    return zoom().scale() * dotsToAPoint();
  }

  void fit() {
    fitting = true;
    changed();
  }

  /** A pixel of the picture to a dot of the screen. */
  void oneToOne() {
    setZoom(Zoom.centred(1 / dotsToAPoint(), picture.getWidth(), picture.getHeight(), getWidth(), getHeight()));
  }

  void zoomAbout(final Point2D place, final double factor) {
    setZoom(zoom().about(place, factor));
  }

  /** Zooms about the pinned pixel, or about the middle. */
  void zoomBy(final double factor) {
    final Rectangle pixel = pinned == null ? null : zoom().onScreen(new Rectangle(pinned, new Dimension(1, 1)));
    final boolean seen = pixel != null && getVisibleRect().intersects(pixel);
    zoomAbout(seen ? new Point2D.Double(pixel.getCenterX(), pixel.getCenterY())
        : new Point2D.Double(getWidth() / 2.0, getHeight() / 2.0), factor);
  }

  void moveBy(final double dx, final double dy) {
    setZoom(zoom().moved(dx, dy));
  }

  /** Pins a pixel; one outside the picture is left alone. */
  void pin(final Point pixel) {
    if (hasPicture && isPixel(pixel)) {
      pinned = new Point(pixel);
      listener.pinned(new Point(pixel));
      repaint();
    }
  }

  /** Pins a pixel and brings it into view, large enough to be seen. */
  void show(final Point pixel) {
    final Zoom near = new Zoom(Math.max(zoom().scale(), PicturePainter.GRID_FROM / dotsToAPoint()), 0, 0);
    setZoom(near.centredOn(pixel, getWidth(), getHeight()));
    pin(pixel);
  }

  /** Pins the pixel beside the pinned one; the middle one, if there is none. */
  void pinBeside(final int dx, final int dy) {
    pin(pinned == null ? new Point(picture.getWidth() / 2, picture.getHeight() / 2)
        : new Point(pinned.x + dx, pinned.y + dy));
  }

  void unpin() {
    pinned = null;
    repaint();
  }

  Point pinned() {
    return pinned == null ? null : new Point(pinned);
  }

  void hover(final Point place) {
    final Point pixel = place == null ? null : zoom().pixelAt(place);
    listener.hovered(pixel != null && hasPicture && isPixel(pixel) ? pixel : null);
  }

  private boolean isPixel(final Point pixel) {
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x < picture.getWidth() && pixel.y < picture.getHeight();
  }

  /** How long it took to paint the picture the last time. */
  double secondsToPaint() {
    return secondsToPaint;
  }

  @Override
  protected void paintComponent(final Graphics graphics) {
    final long begin = System.nanoTime();
    final Graphics2D g = (Graphics2D) graphics.create();
    final AffineTransform toDots = g.getTransform();
    final double scale = toDots.getScaleX();
    final Rectangle clip = g.getClipBounds().intersection(new Rectangle(getSize()));
    final Rectangle part = new Zoom(scale, 0, 0).onScreen(clip);
    prepareDots((int) Math.ceil(getWidth() * scale), (int) Math.ceil(getHeight() * scale));
    paint(part, scale);
    g.setTransform(AffineTransform.getTranslateInstance(Math.round(toDots.getTranslateX()),
        Math.round(toDots.getTranslateY())));
    g.drawImage(dots, part.x, part.y, part.x + part.width, part.y + part.height, part.x, part.y, part.x + part.width,
        part.y + part.height, null);
    g.dispose();
    secondsToPaint = 1e-9 * (System.nanoTime() - begin);
  }

  private void prepareDots(final int width, final int height) {
    if (dots == null || dots.getWidth() != width || dots.getHeight() != height) {
      dots = new BufferedImage(Math.max(1, width), Math.max(1, height), BufferedImage.TYPE_INT_RGB);
    }
  }

  private void paint(final Rectangle part, final double scale) {
    final PicturePainter painter = new PicturePainter(dots, part, zoom(), scale, picture.getWidth(), picture.getHeight());
    painter.paintGround(getBackground(), hasPicture);
    if (hasPicture) {
      painter.paint(picture, filling);
      if (overlay != null) {
        painter.paint(overlay, false);
      }
      painter.paintGrid();
      if (pinned != null) {
        painter.paintFrame(pinned);
      }
    }
    painter.dispose();
  }
}
