package window;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Arc2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.function.ToDoubleFunction;

import javax.swing.SwingUtilities;

import arguments.Messages;
import inspection.BrdfSlice;
import radiometry.RadianceRGB;
import rendering.LightObserver;

/** Plots the BRDF of a surface for the direction of a light, in polar coordinates about the normal. */
final class PolarPlot extends Drawing {

  private static final long serialVersionUID = 1L;

  private static final int MARGIN = 6;
  private static final BasicStroke DASHED =
      new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 1, new float[] {4, 3}, 0);
  private static final Color LIGHT = new Color(0xe08a00);
  private static final Color VIEWER = new Color(0xd000b0);

  private final transient LatestOnlyExecutor background = new LatestOnlyExecutor("BRDF");
  private transient Object request;
  private transient BrdfSlice slice;
  private double viewer;

  PolarPlot() {
    super("polar.name");
    setName("polar");
    setPreferredSize(new Dimension(200, 150));
    setToolTipText(Messages.text("window.polar.tip"));
    setVisible(false);
  }

  void clear() {
    request = null;
    slice = null;
    setVisible(false);
  }

  /** Shows the material of a surface for a light there, once it has been evaluated. */
  void show(final LightObserver.Surface surface, final LightObserver.Contribution light) {
    final Object mine = new Object();
    request = mine;
    background.execute(() -> {
      final BrdfSlice evaluated = BrdfSlice.of(surface.material(), light.cosine(), surface.isOutside());
      SwingUtilities.invokeLater(() -> {
        if (request == mine) {
          show(evaluated, surface);
        }
      });
    });
  }

  private void show(final BrdfSlice evaluated, final LightObserver.Surface surface) {
    slice = evaluated;
    viewer = Math.acos(Math.min(1, Math.abs(surface.normal().dot(surface.ray().getDirection()))));
    setVisible(true);
    revalidate();
    repaint();
  }

  private double max() {
    double max = 0;
    for (final RadianceRGB f : slice.values()) {
      max = Math.max(max, Math.max(f.getR(), Math.max(f.getG(), f.getB())));
    }
    return max;
  }

  @Override
  protected void paintComponent(final Graphics graphics) {
    if (slice == null) {
      return;
    }
    final Graphics2D g = (Graphics2D) graphics.create();
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    final int line = g.getFontMetrics().getHeight();
    final double radius = Math.max(1, Math.min(getWidth() / 2.0 - MARGIN, getHeight() - 2.0 * MARGIN - line));
    final double x = getWidth() / 2.0, y = MARGIN + line + radius;
    g.setColor(getForeground());
    g.drawString(Messages.text("window.polar.text", LightLines.number(max()), LightLines.text(slice.albedo())), MARGIN,
        line - MARGIN / 2);
    g.setColor(Color.GRAY);
    g.draw(new Arc2D.Double(x - radius, y - radius, 2 * radius, 2 * radius, 0, 180, Arc2D.CHORD));
    g.draw(new Line2D.Double(x, y, x, y - radius));
    g.setColor(LIGHT);
    g.setStroke(DASHED);
    g.draw(radius(x, y, radius, -Math.toRadians(slice.incidence())));
    g.setColor(VIEWER);
    g.setStroke(new BasicStroke(1.2f));
    g.draw(radius(x, y, radius, viewer));
    g.setStroke(new BasicStroke(1.6f));
    final List<ToDoubleFunction<RadianceRGB>> channels = List.of(RadianceRGB::getR, RadianceRGB::getG, RadianceRGB::getB);
    final Color[] colours = {new Color(0xd64545), new Color(0x2f9e44), new Color(0x2f7fd6)};
    for (int i = 0; i < colours.length; i++) {
      g.setColor(colours[i]);
      g.draw(curve(channels.get(i), x, y, radius));
    }
    g.dispose();
  }

  private static Line2D radius(final double x, final double y, final double radius, final double angle) {
    return new Line2D.Double(x, y, x + radius * Math.sin(angle), y - radius * Math.cos(angle));
  }

  /** The cube root lets a narrow lobe and a diffuse part be seen together. */
  private Path2D curve(final ToDoubleFunction<RadianceRGB> channel, final double x, final double y, final double radius) {
    final double max = Math.max(max(), Double.MIN_NORMAL);
    final int steps = slice.values().size() - 1;
    final Path2D curve = new Path2D.Double();
    curve.moveTo(x, y);
    for (int i = 0; i <= steps; i++) {
      final double angle = Math.PI * ((double) i / steps - 0.5);
      final double length = radius * Math.cbrt(channel.applyAsDouble(slice.values().get(i)) / max);
      curve.lineTo(x + length * Math.sin(angle), y - length * Math.cos(angle));
    }
    return curve;
  }
}
