package window;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.TexturePaint;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;

/** Shows a picture at any zoom: a checkerboard where it is transparent, a grid between large pixels, a pinned pixel. */
final class PictureView extends Drawing {

  private static final long serialVersionUID = 1L;

  /** Size of a pixel, in dots of the screen, from which on there is a grid. */
  private static final double GRID_FROM = 8;

  private static final int SQUARE = 8;
  private static final Color GRID = new Color(128, 128, 128, 110);

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
  private transient Zoom zoom = new Zoom(1, 0, 0);
  private transient TexturePaint checkerboard;
  private boolean fitting = true;
  private boolean hasPicture;
  private Point pinned;

  PictureView(final PixelListener listener) {
    super("picture.name");
    this.listener = listener;
    setName("picture");
    setFocusable(true);
    setOpaque(true);
    setPreferredSize(new Dimension(640, 480));
    setCursor(Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR));
    getAccessibleContext().setAccessibleDescription(Messages.text("picture.tip"));
    final PictureMouse mouse = new PictureMouse(this);
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
    addMouseWheelListener(mouse);
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
  private double dots() {
    return getGraphicsConfiguration() == null ? 1 : getGraphicsConfiguration().getDefaultTransform().getScaleX();
  }

  Zoom zoom() {
    if (fitting) {
      zoom = Zoom.fit(picture.getWidth(), picture.getHeight(), getWidth(), getHeight());
    }
    return zoom;
  }

  private void setZoom(final Zoom next) {
    final double before = zoom().scale();
    fitting = false;
    zoom = next;
    firePropertyChange("zoom", before, next.scale());
    repaint();
  }

  /** How many dots of the screen a pixel has. */
  double magnification() {
    return zoom().scale() * dots();
  }

  void fit() {
    fitting = true;
    firePropertyChange("zoom", -1.0, zoom().scale());
    repaint();
  }

  /** A pixel of the picture to a dot of the screen. */
  void oneToOne() {
    setZoom(Zoom.centred(1 / dots(), picture.getWidth(), picture.getHeight(), getWidth(), getHeight()));
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
    final Zoom near = new Zoom(Math.max(zoom().scale(), GRID_FROM / dots()), 0, 0);
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

  @Override
  protected void paintComponent(final Graphics graphics) {
    final Graphics2D g = (Graphics2D) graphics.create();
    try {
      final Rectangle clip = g.getClipBounds();
      g.setColor(getBackground());
      g.fillRect(clip.x, clip.y, clip.width, clip.height);
      final Rectangle pixels = zoom().inPicture(clip)
          .intersection(new Rectangle(picture.getWidth(), picture.getHeight()));
      if (hasPicture && !pixels.isEmpty()) {
        paintPixels(g, pixels);
      }
    } finally {
      g.dispose();
    }
  }

  private void paintPixels(final Graphics2D g, final Rectangle pixels) {
    final Rectangle2D place = new Rectangle2D.Double(zoom.x() + pixels.x * zoom.scale(),
        zoom.y() + pixels.y * zoom.scale(), pixels.width * zoom.scale(), pixels.height * zoom.scale());
    g.setPaint(checkerboard());
    g.fill(place);
    g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, magnification() < 1
        ? RenderingHints.VALUE_INTERPOLATION_BILINEAR : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
    final AffineTransform toPlace = new AffineTransform(zoom.scale(), 0, 0, zoom.scale(), place.getX(), place.getY());
    g.drawImage(picture.getSubimage(pixels.x, pixels.y, pixels.width, pixels.height), toPlace, null);
    if (overlay != null) {
      g.drawImage(overlay.getSubimage(pixels.x, pixels.y, pixels.width, pixels.height), toPlace, null);
    }
    if (magnification() >= GRID_FROM) {
      paintGrid(g, pixels, place);
    }
    if (pinned != null) {
      paintPinned(g);
    }
  }

  private TexturePaint checkerboard() {
    if (checkerboard == null) {
      final BufferedImage squares = new BufferedImage(2 * SQUARE, 2 * SQUARE, BufferedImage.TYPE_INT_RGB);
      for (int y = 0; y < 2 * SQUARE; y++) {
        for (int x = 0; x < 2 * SQUARE; x++) {
          squares.setRGB(x, y, x / SQUARE == y / SQUARE ? 0xffffff : 0xd4d4d4);
        }
      }
      checkerboard = new TexturePaint(squares, new Rectangle(2 * SQUARE, 2 * SQUARE));
    }
    return checkerboard;
  }

  private void paintGrid(final Graphics2D g, final Rectangle pixels, final Rectangle2D place) {
    g.setColor(GRID);
    final double thin = 1 / dots();
    for (int i = 0; i <= pixels.width; i++) {
      g.fill(new Rectangle2D.Double(place.getX() + i * zoom.scale(), place.getY(), thin, place.getHeight()));
    }
    for (int i = 0; i <= pixels.height; i++) {
      g.fill(new Rectangle2D.Double(place.getX(), place.getY() + i * zoom.scale(), place.getWidth(), thin));
    }
  }

  /** A frame about the pinned pixel, black and white so that it is seen on any colour, and large enough to be seen. */
  private void paintPinned(final Graphics2D g) {
    final double least = 9, scale = zoom.scale(), size = Math.max(least, scale);
    final double x = zoom.x() + (pinned.x + 0.5) * scale - size / 2, y = zoom.y() + (pinned.y + 0.5) * scale - size / 2;
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setStroke(new BasicStroke(3));
    g.setColor(Color.BLACK);
    g.draw(new Rectangle2D.Double(x, y, size, size));
    g.setStroke(new BasicStroke(1));
    g.setColor(Color.WHITE);
    g.draw(new Rectangle2D.Double(x, y, size, size));
  }
}
