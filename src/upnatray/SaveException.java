package upnatray;

import java.nio.file.Path;

import arguments.Messages;

/** A picture that cannot be had; the message says why, to whom asked for it. */
public final class SaveException extends Exception {

  private static final long serialVersionUID = 1L;

  SaveException(final String key, final Path file, final String reason, final Throwable cause) {
    super(Messages.text("upnatray." + key, file, reason), cause);
  }
}
