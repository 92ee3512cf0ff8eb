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

/** A march as a plot: to the right the distance along the ray, upwards the signed distance, a dot for each step. */
final class SphereTracePlot extends Drawing {

  private static final long serialVersionUID = 1L;

  private static final int MARGIN = 10;
  private static final double DOT = 5;
  private static final Color LINE = new Color(0x2f7fd6);
  private static final Color END = new Color(0xd64545);

  private transient List<SphereTrace.Step> steps = List.of();

  SphereTracePlot() {
    super("march.name");
    setName("march");
    setPreferredSize(new Dimension(200, 150));
    setVisible(false);
    setToolTipText(Messages.text("window.march.tip"));
  }

  /** Shows a march; null for none. Steps to where there is no distance have no place in it. */
  void setMarch(final SphereTrace next) {
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
    double greatestT = 0, most = 0, least = 0;
    for (final SphereTrace.Step step : steps) {
      greatestT = Math.max(greatestT, step.t());
      most = Math.max(most, step.distance());
      least = Math.min(least, step.distance());
    }
    final FontMetrics font = g.getFontMetrics();
    final int top = MARGIN + font.getHeight();
    final double width = getWidth() - 2.0 * MARGIN, height = getHeight() - top - 2.0 * MARGIN;
    final double kx = width / Math.max(greatestT, Double.MIN_NORMAL);
    final double ky = height / Math.max(most - least, Double.MIN_NORMAL);
    final double zero = top + most * ky;
    g.setColor(Color.GRAY);
    g.draw(new Line2D.Double(MARGIN, zero, MARGIN + width, zero));
    g.drawString("SDF " + text(least) + " ... " + text(most), MARGIN, MARGIN + font.getAscent() - 4);
    final String end = "t = " + text(greatestT);
    g.drawString(end, getWidth() - MARGIN - font.stringWidth(end), MARGIN + font.getAscent() - 4);
    paintSteps(g, kx, ky, zero);
    g.dispose();
  }

  private void paintSteps(final Graphics2D g, final double kx, final double ky, final double zero) {
    g.setStroke(new BasicStroke(1));
    final int last = steps.size() - 1;
    double beforeX = 0, beforeY = 0;
    for (int i = 0; i <= last; i++) {
      final SphereTrace.Step step = steps.get(i);
      final double x = MARGIN + step.t() * kx, y = zero - step.distance() * ky;
      g.setColor(LINE);
      if (i > 0) {
        g.draw(new Line2D.Double(beforeX, beforeY, x, y));
      }
      g.draw(new Line2D.Double(x, zero, x, y));
      g.setColor(i == last ? END : LINE);
      g.fill(new Ellipse2D.Double(x - DOT / 2, y - DOT / 2, DOT, DOT));
      beforeX = x;
      beforeY = y;
    }
  }

  private static String text(final double number) {
    return String.format(Locale.ROOT, "%.3g", number);
  }
}
