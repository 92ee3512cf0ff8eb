package window;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;

import javax.swing.SwingUtilities;

/** Handles the mouse in a picture: the wheel zooms about the pointer, dragging pans, a click pins a pixel. */
final class PictureMouse extends MouseAdapter {

  /** Zoom factor of one notch of the wheel. */
  private static final double NOTCH = 1.25;

  /** Distance that the pointer may move between press and release of a click. */
  private static final double CLICK_TOLERANCE = 3;

  private final PictureView view;
  private Point pressed;
  private Point last;

  PictureMouse(final PictureView view) {
    this.view = view;
  }

  @Override
  public void mousePressed(final MouseEvent event) {
    view.requestFocusInWindow();
    pressed = event.getPoint();
    last = pressed;
  }

  @Override
  public void mouseDragged(final MouseEvent event) {
    if (pressed != null && pressed.distance(event.getPoint()) > CLICK_TOLERANCE) {
      pressed = null;
    }
    if (last != null && pressed == null) {
      view.moveBy(event.getX() - last.x, event.getY() - last.y);
      last = event.getPoint();
    }
  }

  @Override
  public void mouseReleased(final MouseEvent event) {
    if (pressed != null && SwingUtilities.isLeftMouseButton(event)) {
      view.pin(view.zoom().pixelAt(event.getPoint()));
    }
    pressed = null;
    last = null;
  }

  @Override
  public void mouseMoved(final MouseEvent event) {
    view.hover(event.getPoint());
  }

  @Override
  public void mouseExited(final MouseEvent event) {
    view.hover(null);
  }

  @Override
  public void mouseWheelMoved(final MouseWheelEvent event) {
    view.zoomAbout(event.getPoint(), Math.pow(NOTCH, -event.getPreciseWheelRotation()));
    view.hover(event.getPoint());
  }
}
