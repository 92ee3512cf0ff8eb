package window;

import java.awt.AlphaComposite;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;

import rendering.Progress;

/**
 * The picture that is shown while it is rendered: at first it looks like the one before, if that has the same size, or is
 * transparent. Rendering writes every pixel once; so there is no need of a copy, which would take time.
 */
final class ProgressivePicture implements Progress {

  private final BufferedImage picture;
  private final Rectangle changed = new Rectangle();

  ProgressivePicture(final BufferedImage toBeRendered, final BufferedImage before) {
    this.picture = toBeRendered;
    if (before != null && before.getWidth() == picture.getWidth() && before.getHeight() == picture.getHeight()) {
      picture.getRaster().setDataElements(0, 0, before.getRaster());
    } else {
      final Graphics2D g = picture.createGraphics();
      g.setComposite(AlphaComposite.Clear);
      g.fillRect(0, 0, picture.getWidth(), picture.getHeight());
      g.dispose();
    }
  }

  BufferedImage picture() {
    return picture;
  }

  @Override
  public boolean tileDone(final int x, final int y, final int width, final int height) {
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
