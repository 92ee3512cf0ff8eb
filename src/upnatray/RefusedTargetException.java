package upnatray;

import java.nio.file.Path;

import arguments.Messages;

/** A picture is not written, because something other than a picture would be lost, or because its name would mislead. */
final class RefusedTargetException extends SaveException {

  private static final long serialVersionUID = 1L;

  RefusedTargetException(final String key, final Path target, final Object... parts) {
    super("refused", target, Messages.text("upnatray." + key, parts), null);
  }
}
