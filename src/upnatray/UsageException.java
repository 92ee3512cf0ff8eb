package upnatray;

import arguments.Messages;

/** A command line that is wrong; the message says how. */
final class UsageException extends Exception {

  private static final long serialVersionUID = 1L;

  UsageException(final String key, final Object... parts) {
    super(Messages.text("upnatray." + key, parts));
  }
}
