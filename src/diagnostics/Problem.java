package diagnostics;

import arguments.Messages;

/**
 * Something wrong in a scene file or in a mesh file, with its place.
 *
 * @param file the file, as it was named to the reader
 * @param line number of the line, from 1; 0 if the file could not be read at all
 * @param column number of the character in its line, from 1; 0 if it is not known
 * @param severity whether the scene can be rendered all the same
 * @param message what is wrong, what was found and what was expected, in the language of the default locale
 */
public record Problem(String file, int line, int column, Severity severity, String message) {

  /** How much a problem matters. */
  public enum Severity {
    /** The scene cannot be rendered. */
    ERROR,
    /** The scene can be rendered, perhaps not as its author meant it. */
    WARNING
  }

  /**
   * Whether the problem keeps the scene from being rendered.
   *
   * @return true for an error
   */
  public boolean isError() {
    return severity == Severity.ERROR;
  }

  /**
   * The problem as one line, {@code FILE:LINE:COLUMN: message} as far as the place is known, the message of a warning
   * after the word {@code warning}.
   *
   * @return the line, without its end
   */
  @Override
  public String toString() {
    final String place = line == 0 ? file : file + ":" + line + (column == 0 ? "" : ":" + column);
    return place + ": " + (isError() ? message : Messages.text("diagnostics.warning", message));
  }
}
