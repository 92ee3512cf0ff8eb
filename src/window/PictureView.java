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

/** Shows a picture at any zoom: checkerboard behind it, grid between large pixels, frame around the pinned pixel. */
final class PictureView extends Drawing {

  private static final long serialVersionUID = 1L;

  /** Receives the pixels that the user points at, counted from the upper left corner. */
  interface PixelListener {

    /** The pointer is over a pixel; null if it is over none. */
    void hovered(Point pixel);

    /** A pixel has been pinned. */
    void pinned(Point pixel);
  }

  private final transient PixelListener listener;
  private transient BufferedImage picture = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB);
  private transient BufferedImage overlay;
  private transient BufferedImage preview;
  private transient RayOverlay rays = RayOverlay.NONE;
  private transient BufferedImage buffer;
  private transient Zoom zoom = new Zoom(1, 0, 0);
  private transient CameraControl camera;
  private boolean fitting = true;
  private boolean hasPicture;
  private boolean rendering;
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
    addPropertyChangeListener("graphicsConfiguration", event -> changed());
    addComponentListener(new ComponentAdapter() {
      @Override
      public void componentResized(final ComponentEvent event) {
        changed();
      }
    });
  }

  /** Removes the picture. */
  void clear() {
    hasPicture = false;
    overlay = null;
    changed();
  }

  /** Shows another picture. Zoom and pinned pixel are kept if it has the same size. */
  void setPicture(final BufferedImage next) {
    final boolean sameSize = next.getWidth() == picture.getWidth() && next.getHeight() == picture.getHeight();
    picture = next;
    hasPicture = true;
    overlay = null;
    preview = null;
    rays = RayOverlay.NONE;
    if (!sameSize) {
      fitting = true;
      pinned = null;
    }
    changed();
  }

  /** Shows another picture of the same size and content. Rays and a preview shown over it are kept. */
  void refine(final BufferedImage next) {
    picture = next;
    overlay = null;
    repaint();
  }

  private void changed() {
    firePropertyChange("zoom", -1.0, zoom().scale());
    repaint();
  }

  /** Sets whether the picture is being rendered; if so it is painted as fast as possible. */
  void setRendering(final boolean next) {
    rendering = next;
    repaint();
  }

  BufferedImage picture() {
    return picture;
  }

  boolean hasPicture() {
    return hasPicture;
  }

  /** Sets an image to be shown over the picture, such as the mask of a comparison; null for none. */
  void setOverlay(final BufferedImage mask) {
    overlay = mask;
    repaint();
  }

  /** Shows a coarse picture in place of the picture, stretched to its size; null for none. */
  void setPreview(final BufferedImage next) {
    preview = next;
    repaint();
  }

  /** What is shown in place of the picture; null if it is the picture. */
  BufferedImage preview() {
    return preview;
  }

  /** Shows projected rays over the picture. */
  void setRays(final RayOverlay next) {
    rays = next;
    repaint();
  }

  boolean hasOverlay() {
    return overlay != null;
  }

  /** Repaints pixels that have changed. */
  void repaintPixels(final Rectangle pixels) {
    if (!pixels.isEmpty()) {
      final Rectangle dirty = zoom().onScreen(pixels);
      dirty.grow(2, 2);
      repaint(dirty);
    }
  }

  /** Device pixels per unit of the component's coordinates. */
  private double deviceScale() {
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

  /** Device pixels per pixel of the picture. */
  double magnification() {
    return zoom().scale() * deviceScale();
  }

  void fit() {
    fitting = true;
    changed();
  }

  /** Shows each pixel of the picture as one device pixel. */
  void oneToOne() {
    setZoom(Zoom.centred(1 / deviceScale(), picture.getWidth(), picture.getHeight(), getWidth(), getHeight()));
  }

  void zoomAbout(final Point2D place, final double factor) {
    setZoom(zoom().about(place, factor));
  }

  /** Zooms about the pinned pixel if it is visible, else about the centre. */
  void zoomBy(final double factor) {
    final Rectangle pixel = pinned == null ? null : zoom().onScreen(new Rectangle(pinned, new Dimension(1, 1)));
    final boolean visible = pixel != null && getVisibleRect().intersects(pixel);
    zoomAbout(visible ? new Point2D.Double(pixel.getCenterX(), pixel.getCenterY())
        : new Point2D.Double(getWidth() / 2.0, getHeight() / 2.0), factor);
  }

  /** Sets the control of the camera, which middle and Alt drags and Ctrl with the wheel move. */
  void setCamera(final CameraControl control) {
    camera = control;
  }

  CameraControl camera() {
    return camera;
  }

  void moveBy(final double dx, final double dy) {
    setZoom(zoom().moved(dx, dy));
  }

  /** Pins a pixel; a pixel outside the picture is ignored. */
  void pin(final Point pixel) {
    if (hasPicture && isPixel(pixel)) {
      pinned = new Point(pixel);
      listener.pinned(new Point(pixel));
      repaint();
    }
  }

  /** Pins a pixel and centres it, magnified enough to be recognisable. */
  void show(final Point pixel) {
    final Zoom near = new Zoom(Math.max(zoom().scale(), PicturePainter.MIN_GRID_SIZE / deviceScale()), 0, 0);
    setZoom(near.centredOn(pixel, getWidth(), getHeight()));
    pin(pixel);
  }

  /** Pins a neighbour of the pinned pixel, or the central pixel if none is pinned. */
  void pinNeighbour(final int dx, final int dy) {
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

  /** Duration of the last painting, in seconds. */
  double secondsToPaint() {
    return secondsToPaint;
  }

  @Override
  protected void paintComponent(final Graphics graphics) {
    final long begin = System.nanoTime();
    final Graphics2D g = (Graphics2D) graphics.create();
    final AffineTransform toDevice = g.getTransform();
    final double scale = toDevice.getScaleX();
    final Rectangle clip = g.getClipBounds().intersection(new Rectangle(getSize()));
    final Rectangle part = new Zoom(scale, 0, 0).onScreen(clip);
    prepareBuffer((int) Math.ceil(getWidth() * scale), (int) Math.ceil(getHeight() * scale));
    paint(part, scale);
    g.setTransform(AffineTransform.getTranslateInstance(Math.round(toDevice.getTranslateX()),
        Math.round(toDevice.getTranslateY())));
    g.drawImage(buffer, part.x, part.y, part.x + part.width, part.y + part.height, part.x, part.y, part.x + part.width,
        part.y + part.height, null);
    g.dispose();
    secondsToPaint = 1e-9 * (System.nanoTime() - begin);
  }

  private void prepareBuffer(final int width, final int height) {
    if (buffer == null || buffer.getWidth() != width || buffer.getHeight() != height) {
      buffer = new BufferedImage(Math.max(1, width), Math.max(1, height), BufferedImage.TYPE_INT_RGB);
    }
  }

  private void paint(final Rectangle part, final double scale) {
    final PicturePainter painter = new PicturePainter(buffer, part, zoom(), scale,
        new Dimension(picture.getWidth(), picture.getHeight()));
    painter.paintGround(getBackground(), hasPicture);
    if (hasPicture) {
      final BufferedImage shown = preview == null ? picture : preview;
      painter.paint(shown, rendering || shown.getWidth() != picture.getWidth());
      if (overlay != null) {
        painter.paint(overlay, false);
      }
      painter.paintGrid();
      painter.paintRays(rays);
      if (pinned != null) {
        painter.paintFrame(pinned);
      }
    }
    painter.dispose();
  }
}
