package window;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Stream;

import javax.swing.SwingUtilities;

import arguments.Messages;
import inspection.Wireframe;
import primitives.BoundingBox;
import primitives.Point3D;

/**
 * A line drawing of a scene and its camera. Dragging rotates it (horizontally about the scene's y axis); with shift or
 * another button it pans; the wheel zooms about the pointer.
 */
final class WireframeView extends Drawing {

  private static final long serialVersionUID = 1L;

  private static final double DEGREES_PER_UNIT = 0.5;
  private static final double NOTCH = 1.15;

  private transient List<Wireframe.Line> lines = List.of();
  private transient List<Wireframe.Line> selected = List.of();
  private double yaw = 35;
  private double pitch = 25;
  private double zoom = 1;
  private double moveX;
  private double moveY;
  private Point3D centre = new Point3D();
  private double radius = 1;
  private Point last;

  WireframeView() {
    super("wireframe.name");
    setName("wireframe");
    setFocusable(true);
    setPreferredSize(new Dimension(720, 540));
    getAccessibleContext().setAccessibleDescription(Messages.text("window.wireframe.tip"));
    setToolTipText(Messages.text("window.wireframe.tip"));
    final MouseAdapter mouse = new Mouse();
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
    addMouseWheelListener(mouse);
  }

  void setLines(final List<Wireframe.Line> next) {
    lines = next;
    final BoundingBox box = Wireframe.bounds(next);
    centre = box.getMin();
    centre.interpolate(box.getMax(), 0.5f);
    radius = centre.distance(box.getMax());
    repaint();
  }

  /** Sets rays to be drawn over the others, such as those selected in the inspector. */
  void setSelected(final List<Wireframe.Line> next) {
    selected = next.stream().map(line -> new Wireframe.Line(Wireframe.Kind.SELECTED, line.from(), line.to(), 0)).toList();
    repaint();
  }

  void turn(final double degreesAcross, final double degreesDown) {
    yaw += degreesAcross;
    pitch = Math.max(-90, Math.min(90, pitch + degreesDown));
    repaint();
  }

  /** Zooms about a fixed point, given relative to the centre of the component. */
  void zoomAbout(final double x, final double y, final double factor) {
    zoom *= factor;
    moveX = x - factor * (x - moveX);
    moveY = y - factor * (y - moveY);
    repaint();
  }

  void zoomBy(final double factor) {
    zoomAbout(0, 0, factor);
  }

  void moveBy(final double dx, final double dy) {
    moveX += dx;
    moveY += dy;
    repaint();
  }

  /** Shows the whole drawing. */
  void fit() {
    zoom = 1;
    moveX = 0;
    moveY = 0;
    repaint();
  }

  /** The visible drawing at twice its size. */
  BufferedImage image() {
    final BufferedImage image = new BufferedImage(2 * getWidth(), 2 * getHeight(), BufferedImage.TYPE_INT_ARGB);
    final Graphics2D g = image.createGraphics();
    g.scale(2, 2);
    paintComponent(g);
    g.dispose();
    return image;
  }

  @Override
  protected void paintComponent(final Graphics graphics) {
    final Graphics2D g = (Graphics2D) graphics.create();
    g.setColor(Color.WHITE);
    g.fillRect(0, 0, getWidth(), getHeight());
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    if (!lines.isEmpty()) {
      paintLines(g);
    }
    g.dispose();
  }

  private void paintLines(final Graphics2D g) {
    final double k = scale();
    final double left = 0.5 * getWidth() + moveX - k * across(centre), top = 0.5 * getHeight() + moveY + k * up(centre);
    for (final Wireframe.Line line : Stream.concat(lines.stream(), selected.stream()).toList()) {
      final double x = left + k * across(line.to()), y = top - k * up(line.to());
      g.setColor(colour(line));
      g.setStroke(stroke(line.kind()));
      g.draw(new Line2D.Double(left + k * across(line.from()), top - k * up(line.from()), x, y));
      drawLabel(g, line.kind(), x, y);
    }
  }

  /** Component coordinates per unit of the scene, such that the drawing fits from every direction. */
  private double scale() {
    return 0.48 * zoom * Math.min(getWidth(), getHeight()) / Math.max(radius, Float.MIN_NORMAL);
  }

  private double across(final Point3D P) {
    final double a = Math.toRadians(yaw);
    return Math.cos(a) * P.x - Math.sin(a) * P.z;
  }

  private double up(final Point3D P) {
    final double a = Math.toRadians(yaw), b = Math.toRadians(pitch);
    return Math.cos(b) * P.y - Math.sin(b) * (Math.sin(a) * P.x + Math.cos(a) * P.z);
  }

  /** Boxes have the colour of their object, darkened if it would be invisible on white. */
  private static Color colour(final Wireframe.Line line) {
    if (WireframeColours.has(line.kind())) {
      return WireframeColours.of(line.kind());
    }
    final Color own = line.argb() == 0 ? Color.GRAY : new Color(line.argb());
    return own.getRed() + own.getGreen() + own.getBlue() > 600 ? own.darker() : own;
  }

  private static BasicStroke stroke(final Wireframe.Kind kind) {
    return switch (kind) {
      case GRID -> new BasicStroke(0.5f);
      case FRUSTUM -> new BasicStroke(0.8f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 1, new float[] {5, 4}, 0);
      case SHADOW_BLOCKED -> new BasicStroke(1.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 1, new float[] {2, 3}, 0);
      case SHADOW_LIT, REFLECTED, REFRACTED -> new BasicStroke(1.4f);
      case SELECTED -> new BasicStroke(3);
      case BOX, AROUND, PLANE -> new BasicStroke(0.9f);
      default -> new BasicStroke(2);
    };
  }

  private static void drawLabel(final Graphics2D g, final Wireframe.Kind kind, final double x, final double y) {
    final String label = switch (kind) {
      case AXIS_X -> "x";
      case AXIS_Y -> "y";
      case AXIS_Z -> "z";
      case NORMAL -> "n";
      default -> "";
    };
    g.drawString(label, (float) x + 4, (float) y - 3);
  }

  /** Rotates, pans and zooms. */
  private final class Mouse extends MouseAdapter {

    @Override
    public void mousePressed(final MouseEvent event) {
      requestFocusInWindow();
      last = event.getPoint();
    }

    @Override
    public void mouseDragged(final MouseEvent event) {
      final int dx = event.getX() - last.x, dy = event.getY() - last.y;
      if (event.isShiftDown() || !SwingUtilities.isLeftMouseButton(event)) {
        moveBy(dx, dy);
      } else {
        turn(DEGREES_PER_UNIT * dx, DEGREES_PER_UNIT * dy);
      }
      last = event.getPoint();
    }

    @Override
    public void mouseWheelMoved(final MouseWheelEvent event) {
      zoomAbout(event.getX() - 0.5 * getWidth(), event.getY() - 0.5 * getHeight(),
          Math.pow(NOTCH, -event.getPreciseWheelRotation()));
    }
  }
}
