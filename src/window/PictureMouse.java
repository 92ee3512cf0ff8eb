package window;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;

import javax.swing.SwingUtilities;

/**
 * Handles the mouse in a picture: the wheel zooms about the pointer, dragging pans, a click pins a pixel. With Alt, Ctrl or
 * the middle button it moves the camera.
 */
final class PictureMouse extends MouseAdapter {

  /** Zoom factor of one notch of the wheel. */
  private static final double NOTCH = 1.25;

  /** Factor of one notch for the distance of the camera. */
  private static final double CAMERA_NOTCH = 1.1;

  /** Distance that the pointer may move between press and release of a click. */
  private static final double CLICK_TOLERANCE = 3;

  private final PictureView view;
  private Point pressed;
  private Point last;
  private boolean movesCamera;

  PictureMouse(final PictureView view) {
    this.view = view;
  }

  @Override
  public void mousePressed(final MouseEvent event) {
    view.requestFocusInWindow();
    pressed = event.getPoint();
    last = pressed;
    movesCamera = SwingUtilities.isMiddleMouseButton(event) || event.isAltDown();
  }

  @Override
  public void mouseDragged(final MouseEvent event) {
    if (pressed != null && pressed.distance(event.getPoint()) > CLICK_TOLERANCE) {
      pressed = null;
    }
    if (last != null && pressed == null) {
      final int dx = event.getX() - last.x, dy = event.getY() - last.y;
      if (!movesCamera) {
        view.moveBy(dx, dy);
      } else if (event.isShiftDown()) {
        final double height = view.zoom().scale() * view.picture().getHeight();
        view.camera().move(dx / height, dy / height);
      } else {
        view.camera().turn(dx, dy);
      }
      last = event.getPoint();
    }
  }

  @Override
  public void mouseReleased(final MouseEvent event) {
    if (pressed != null && SwingUtilities.isLeftMouseButton(event) && !movesCamera) {
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
    if (event.isControlDown()) {
      view.camera().nearer(Math.pow(CAMERA_NOTCH, -event.getPreciseWheelRotation()));
      return;
    }
    view.zoomAbout(event.getPoint(), Math.pow(NOTCH, -event.getPreciseWheelRotation()));
    view.hover(event.getPoint());
  }
}
