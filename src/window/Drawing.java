package window;

import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;

import arguments.Messages;

/** A component that paints itself. Assistive technology sees a canvas with a name and a description. */
abstract class Drawing extends JComponent {

  private static final long serialVersionUID = 1L;

  /** A drawing whose accessible name is in the message bundle. */
  Drawing(final String key) {
    getAccessibleContext().setAccessibleName(Messages.text("window." + key));
  }

  @Override
  public final AccessibleContext getAccessibleContext() {
    if (accessibleContext == null) {
      accessibleContext = new AccessibleJComponent() {
        private static final long serialVersionUID = 1L;

        @Override
        public AccessibleRole getAccessibleRole() {
          return AccessibleRole.CANVAS;
        }
      };
    }
    return accessibleContext;
  }
}
