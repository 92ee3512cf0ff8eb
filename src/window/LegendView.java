package window;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.util.Locale;

import arguments.Messages;
import rendering.ColourScale;

/** The legend of a pass that shows numbers: a vertical colour bar with tick marks. */
final class LegendView extends Drawing {

  private static final long serialVersionUID = 1L;

  private static final int BAR = 18;
  private static final int MARGIN = 12;
  private static final int TICKS = 6;

  private transient ColourScale scale;

  LegendView() {
    super("legend.name");
    setName("legend");
    setPreferredSize(new Dimension(96, 10));
    setVisible(false);
  }

  /** Sets the scale; null hides the legend. */
  void setScale(final ColourScale next) {
    scale = next;
    setVisible(next != null);
    if (next != null) {
      getAccessibleContext().setAccessibleDescription(text(next, next.least()) + " ... " + text(next, next.greatest()));
      setToolTipText(Messages.text(next.isDepth() ? "window.legend.depth.tip" : "window.legend.cost.tip"));
    }
    repaint();
  }

  static String text(final ColourScale scale, final double value) {
    return scale.isDepth() ? String.format(Locale.ROOT, "%.4g", value) : String.valueOf(Math.round(value));
  }

  @Override
  protected void paintComponent(final Graphics g) {
    final FontMetrics font = g.getFontMetrics();
    final int top = MARGIN + 2 * font.getHeight(), height = getHeight() - top - 2 * MARGIN;
    if (scale == null || height < TICKS * font.getHeight()) {
      return;
    }
    g.setColor(getForeground());
    g.drawString(Messages.text(scale.isDepth() ? "window.legend.depth" : "window.legend.cost"), MARGIN / 2, MARGIN
        + font.getAscent());
    for (int y = 0; y < height; y++) {
      g.setColor(new Color(scale.argbAt((double) y / (height - 1))));
      g.fillRect(MARGIN, top + y, BAR, 1);
    }
    g.setColor(getForeground());
    g.drawRect(MARGIN - 1, top - 1, BAR + 1, height + 1);
    for (int i = 0; i < TICKS; i++) {
      final int y = top + (height - 1) * i / (TICKS - 1);
      g.drawLine(MARGIN + BAR, y, MARGIN + BAR + 3, y);
      final String text = text(scale, scale.value((double) i / (TICKS - 1)));
      g.drawString(text, MARGIN + BAR + 6, y + font.getAscent() / 2 - 1);
    }
  }
}
