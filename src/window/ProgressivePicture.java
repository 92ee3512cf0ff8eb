package window;

import java.awt.AlphaComposite;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;

import rendering.Progress;

/**
 * A picture shown while it is rendered. Initially it shows the previous picture if that has the same size, else it is
 * transparent. As rendering writes each pixel exactly once, no copy is needed.
 */
final class ProgressivePicture implements Progress {

  private final BufferedImage image;
  private final Rectangle changed = new Rectangle();

  ProgressivePicture(final BufferedImage image, final BufferedImage previous) {
    this.image = image;
    if (previous != null && previous.getWidth() == image.getWidth() && previous.getHeight() == image.getHeight()) {
      image.getRaster().setDataElements(0, 0, previous.getRaster());
    } else {
      final Graphics2D g = image.createGraphics();
      g.setComposite(AlphaComposite.Clear);
      g.fillRect(0, 0, image.getWidth(), image.getHeight());
      g.dispose();
    }
  }

  BufferedImage image() {
    return image;
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

  /** Returns the region that has changed since the previous call. */
  Rectangle takeChanged() {
    synchronized (changed) {
      final Rectangle taken = new Rectangle(changed);
      changed.setBounds(0, 0, 0, 0);
      return taken;
    }
  }
}
