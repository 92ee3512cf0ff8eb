package window;

import java.awt.Point;

/** Shows and inspects the pixels that the user points at. */
final class PixelPointer implements PictureView.PixelListener {

  private final RenderWindow window;

  PixelPointer(final RenderWindow window) {
    this.window = window;
  }

  @Override
  public void hovered(final Point pixel) {
    final PictureView view = window.view();
    window.status().showPixel(pixel, view.picture().getHeight(),
        pixel == null ? 0 : view.picture().getRGB(pixel.x, pixel.y));
  }

  @Override
  public void pinned(final Point pixel) {
    hovered(pixel);
    if (window.job() != null) {
      window.inspections().inspect(window.job(), pixel);
    }
  }
}
