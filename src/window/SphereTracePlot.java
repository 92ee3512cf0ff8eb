package window;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.List;
import java.util.Locale;

import arguments.Messages;
import models.SphereTrace;

/** Plots a sphere trace: the signed distance over the distance along the ray, with a dot for each step. */
final class SphereTracePlot extends Drawing {

  private static final long serialVersionUID = 1L;

  private static final int MARGIN = 10;
  private static final double DOT = 5;
  private static final Color LINE = new Color(0x2f7fd6);
  private static final Color END = new Color(0xd64545);

  private transient List<SphereTrace.Step> steps = List.of();

  SphereTracePlot() {
    super("trace.name");
    setName("trace");
    setPreferredSize(new Dimension(200, 150));
    setVisible(false);
    setToolTipText(Messages.text("window.trace.tip"));
  }

  /** Shows a trace; null hides the plot. Steps without a finite distance are left out. */
  void setTrace(final SphereTrace next) {
    steps = next == null ? List.of() : next.steps().stream()
        .filter(step -> Double.isFinite(step.t()) && Double.isFinite(step.distance())).toList();
    setVisible(next != null);
    revalidate();
    repaint();
  }

  @Override
  protected void paintComponent(final Graphics graphics) {
    if (steps.isEmpty()) {
      return;
    }
    final Graphics2D g = (Graphics2D) graphics.create();
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    double maxT = 0, max = 0, min = 0;
    for (final SphereTrace.Step step : steps) {
      maxT = Math.max(maxT, step.t());
      max = Math.max(max, step.distance());
      min = Math.min(min, step.distance());
    }
    final FontMetrics font = g.getFontMetrics();
    final int top = MARGIN + font.getHeight();
    final double width = getWidth() - 2.0 * MARGIN, height = getHeight() - top - 2.0 * MARGIN;
    final double kx = width / Math.max(maxT, Double.MIN_NORMAL);
    final double ky = height / Math.max(max - min, Double.MIN_NORMAL);
    final double zero = top + max * ky;
    g.setColor(Color.GRAY);
    g.draw(new Line2D.Double(MARGIN, zero, MARGIN + width, zero));
    g.drawString("SDF " + text(min) + " ... " + text(max), MARGIN, MARGIN + font.getAscent() - 4);
    final String end = "t = " + text(maxT);
    g.drawString(end, getWidth() - MARGIN - font.stringWidth(end), MARGIN + font.getAscent() - 4);
    paintSteps(g, kx, ky, zero);
    g.dispose();
  }

  private void paintSteps(final Graphics2D g, final double kx, final double ky, final double zero) {
    g.setStroke(new BasicStroke(1));
    final int last = steps.size() - 1;
    double previousX = 0, previousY = 0;
    for (int i = 0; i <= last; i++) {
      final SphereTrace.Step step = steps.get(i);
      final double x = MARGIN + step.t() * kx, y = zero - step.distance() * ky;
      g.setColor(LINE);
      if (i > 0) {
        g.draw(new Line2D.Double(previousX, previousY, x, y));
      }
      g.draw(new Line2D.Double(x, zero, x, y));
      g.setColor(i == last ? END : LINE);
      g.fill(new Ellipse2D.Double(x - DOT / 2, y - DOT / 2, DOT, DOT));
      previousX = x;
      previousY = y;
    }
  }

  private static String text(final double number) {
    return String.format(Locale.ROOT, "%.3g", number);
  }
}
