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
import java.util.Map;

import inspection.Outline;
import primitives.Point3D;

/**
 * A scene and its camera from outside, as lines. Dragging turns it (left and right about the scene's y), the wheel and the
 * keys + and − change its size.
 */
final class OutsideView extends Drawing {

  private static final long serialVersionUID = 1L;

  private static final double DEGREES_TO_A_POINT = 0.5;
  private static final double NOTCH = 1.15;
  private static final Map<Outline.Kind, Color> COLOURS = Map.of(Outline.Kind.AXIS_X, new Color(0xd03030),
      Outline.Kind.AXIS_Y, new Color(0x2f9e44), Outline.Kind.AXIS_Z, new Color(0x3060d0),
      Outline.Kind.WINDOW, new Color(0xe08a00), Outline.Kind.GRID, new Color(0xd9b477),
      Outline.Kind.FRUSTUM, new Color(0xb0b0b0), Outline.Kind.RAY, new Color(0xd000b0),
      Outline.Kind.NORMAL, new Color(0x00a0b0));

  private transient List<Outline.Line> lines = List.of();
  private double yaw = 35;
  private double pitch = 25;
  private double zoom = 1;
  private Point last;

  OutsideView() {
    super("outside.name");
    setName("outside");
    setFocusable(true);
    setPreferredSize(new Dimension(720, 540));
    getAccessibleContext().setAccessibleDescription(Messages.text("outside.tip"));
    setToolTipText(Messages.text("outside.tip"));
    final MouseAdapter mouse = new Mouse();
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
    addMouseWheelListener(mouse);
  }

  void setLines(final List<Outline.Line> next) {
    lines = next;
    repaint();
  }

  void turn(final double degreesAcross, final double degreesDown) {
    yaw += degreesAcross;
    pitch = Math.max(-90, Math.min(90, pitch + degreesDown));
    repaint();
  }

  void zoomBy(final double factor) {
    zoom *= factor;
    repaint();
  }

  /** The drawing as it is seen, twice as large. */
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
    final double[] x = new double[2 * lines.size()], y = new double[2 * lines.size()];
    double left = Double.POSITIVE_INFINITY, right = -left, top = left, bottom = right;
    for (int i = 0; i < x.length; i++) {
      final Outline.Line line = lines.get(i / 2);
      final Point3D P = i % 2 == 0 ? line.from() : line.to();
      x[i] = across(P);
      y[i] = -up(P);
      if (line.kind() != Outline.Kind.FRUSTUM) {
        left = Math.min(left, x[i]);
        right = Math.max(right, x[i]);
        top = Math.min(top, y[i]);
        bottom = Math.max(bottom, y[i]);
      }
    }
    final double k = 0.9 * zoom * Math.min(getWidth() / Math.max(right - left, Float.MIN_NORMAL),
        getHeight() / Math.max(bottom - top, Float.MIN_NORMAL));
    final double cx = 0.5 * (getWidth() - k * (left + right)), cy = 0.5 * (getHeight() - k * (top + bottom));
    for (int i = 0; i < lines.size(); i++) {
      final Outline.Line line = lines.get(i);
      g.setColor(colour(line));
      g.setStroke(stroke(line.kind()));
      g.draw(new Line2D.Double(cx + k * x[2 * i], cy + k * y[2 * i], cx + k * x[2 * i + 1], cy + k * y[2 * i + 1]));
      letter(g, line.kind(), cx + k * x[2 * i + 1], cy + k * y[2 * i + 1]);
    }
  }

  private double across(final Point3D P) {
    final double a = Math.toRadians(yaw);
    return Math.cos(a) * P.x - Math.sin(a) * P.z;
  }

  private double up(final Point3D P) {
    final double a = Math.toRadians(yaw), b = Math.toRadians(pitch);
    return Math.cos(b) * P.y - Math.sin(b) * (Math.sin(a) * P.x + Math.cos(a) * P.z);
  }

  /** Boxes have the colour of their object, but never one so light that it is not seen on white. */
  private static Color colour(final Outline.Line line) {
    if (line.kind() != Outline.Kind.BOX && line.kind() != Outline.Kind.PLANE) {
      return COLOURS.get(line.kind());
    }
    final Color own = line.argb() == 0 ? Color.GRAY : new Color(line.argb());
    return own.getRed() + own.getGreen() + own.getBlue() > 600 ? own.darker() : own;
  }

  private static BasicStroke stroke(final Outline.Kind kind) {
    return switch (kind) {
      case GRID -> new BasicStroke(0.5f);
      case FRUSTUM -> new BasicStroke(0.8f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 1, new float[] {5, 4}, 0);
      case BOX, PLANE -> new BasicStroke(0.9f);
      default -> new BasicStroke(2);
    };
  }

  private static void letter(final Graphics2D g, final Outline.Kind kind, final double x, final double y) {
    final String letter = switch (kind) {
      case AXIS_X -> "x";
      case AXIS_Y -> "y";
      case AXIS_Z -> "z";
      case NORMAL -> "n";
      default -> "";
    };
    g.drawString(letter, (float) x + 4, (float) y - 3);
  }

  /** Turns and zooms. */
  private final class Mouse extends MouseAdapter {

    @Override
    public void mousePressed(final MouseEvent event) {
      requestFocusInWindow();
      last = event.getPoint();
    }

    @Override
    public void mouseDragged(final MouseEvent event) {
      turn(DEGREES_TO_A_POINT * (event.getX() - last.x), DEGREES_TO_A_POINT * (event.getY() - last.y));
      last = event.getPoint();
    }

    @Override
    public void mouseWheelMoved(final MouseWheelEvent event) {
      zoomBy(Math.pow(NOTCH, -event.getPreciseWheelRotation()));
    }
  }
}
