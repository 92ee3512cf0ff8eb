package upnatray;

import java.nio.file.Path;

import arguments.Messages;

/** Rendering or saving a picture failed; the message says why, for the user. */
public class SaveException extends Exception {

  private static final long serialVersionUID = 1L;

  SaveException(final String key, final Path file, final String reason, final Throwable cause) {
    super(Messages.text("upnatray." + key, file, reason), cause);
  }
}
