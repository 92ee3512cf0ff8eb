package window;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.Raster;

import upnatray.Progress;

/**
 * The picture that is shown while another is rendered: at first the one before, if it has the same size, or transparent;
 * each tile that is done takes its place.
 */
final class Canvas implements Progress {

  private final BufferedImage rendered;
  private final BufferedImage picture;
  private final Rectangle changed = new Rectangle();

  Canvas(final BufferedImage rendered, final BufferedImage before) {
    this.rendered = rendered;
    this.picture = new BufferedImage(rendered.getWidth(), rendered.getHeight(), BufferedImage.TYPE_INT_ARGB);
    if (before != null && before.getWidth() == rendered.getWidth() && before.getHeight() == rendered.getHeight()) {
      picture.setData(before.getRaster());
    }
  }

  BufferedImage picture() {
    return picture;
  }

  @Override
  public boolean tileDone(final int x, final int y, final int width, final int height) {
    final Raster tile = rendered.getRaster().createChild(x, y, width, height, x, y, null);
    picture.getRaster().setDataElements(0, 0, tile);
    synchronized (changed) {
      if (changed.isEmpty()) {
        changed.setBounds(x, y, width, height);
      } else {
        changed.add(new Rectangle(x, y, width, height));
      }
    }
    return true;
  }

  /** The part of the picture that has changed since the last time that this was asked. */
  Rectangle takeChanged() {
    synchronized (changed) {
      final Rectangle taken = new Rectangle(changed);
      changed.setBounds(0, 0, 0, 0);
      return taken;
    }
  }
}
