package upnatray;

import arguments.Messages;

/** An invalid command line; the message says why. */
final class UsageException extends Exception {

  private static final long serialVersionUID = 1L;

  UsageException(final String key, final Object... parts) {
    super(Messages.text("upnatray." + key, parts));
  }
}
