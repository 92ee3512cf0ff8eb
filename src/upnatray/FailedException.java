package upnatray;

import java.nio.file.Path;

/** A picture that cannot be had; the message says why, to whom asked for it. */
public final class FailedException extends Exception {

  private static final long serialVersionUID = 1L;

  FailedException(final String key, final Path file, final String reason, final Throwable cause) {
    super(Messages.text(key, file, reason), cause);
  }
}
