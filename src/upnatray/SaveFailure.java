package upnatray;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.NoSuchFileException;

import arguments.Messages;

/** Why a file could not be written, in the user's language where the reason is known. */
final class SaveFailure {

  private SaveFailure() {
  }

  static String reason(final IOException failure) {
    if (failure instanceof AccessDeniedException denied) {
      return denied.getOtherFile() == null ? Messages.text("upnatray.denied", denied.getFile())
          : Messages.text("upnatray.inUse");
    }
    if (failure instanceof FileAlreadyExistsException exists) {
      return Messages.text("upnatray.noFolder", exists.getFile());
    }
    if (failure instanceof NoSuchFileException missing) {
      return Messages.text("upnatray.missing", missing.getFile());
    }
    if (failure instanceof FileSystemLoopException) {
      return Messages.text("upnatray.linkLoop");
    }
    if (failure instanceof FileSystemException other && other.getReason() != null) {
      return other.getOtherFile() == null ? other.getReason()
          : Messages.text("upnatray.inUse") + " (" + other.getReason() + ")";
    }
    return failure.getMessage() == null ? failure.getClass().getSimpleName() : failure.getMessage();
  }
}
