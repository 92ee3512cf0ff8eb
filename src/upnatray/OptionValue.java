package upnatray;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.StringJoiner;

import diagnostics.LocaleCharset;
import rendering.RenderPass;

/**
 * The value of an option of the command line.
 *
 * @param option name of the option, as it was written
 * @param value its value, as it was written; null if none
 */
record OptionValue(String option, String value) {

  /** The value as it is; it must not be empty. */
  String text() throws UsageException {
    if (value == null || value.isEmpty()) {
      throw new UsageException("valueMissing", option);
    }
    return value;
  }

  /** A whole number of at least 1. */
  int count() throws UsageException {
    return number(text(), 1);
  }

  private int number(final String text, final int least) throws UsageException {
    try {
      final int number = Integer.parseInt(text);
      if (number >= least) {
        return number;
      }
    } catch (final NumberFormatException noNumber) {
      throw new UsageException("notCount", option, text, least);
    }
    throw new UsageException("notCount", option, text, least);
  }

  /** A whole number from one limit to another, both included. */
  int within(final int least, final int most) throws UsageException {
    final int number = number(text(), 1);
    if (number < least || number > most) {
      throw new UsageException("notWithin", option, least, most, value);
    }
    return number;
  }

  /** Two whole numbers A-B, the first at most the second, and neither below a limit. */
  int[] range(final int least) throws UsageException {
    final String text = text();
    final int dash = text.indexOf('-');
    if (dash <= 0) {
      throw new UsageException("notRange", option, text);
    }
    final int first = number(text.substring(0, dash), least), last = number(text.substring(dash + 1), least);
    if (first > last) {
      throw new UsageException("notRange", option, text);
    }
    return new int[] {first, last};
  }

  /** A decimal number greater than 0. */
  double positive() throws UsageException {
    final String text = text();
    if (text.matches("\\d*\\.?\\d+|\\d+\\.")) {
      final double number = Double.parseDouble(text);
      if (number > 0 && number < Double.POSITIVE_INFINITY) {
        return number;
      }
    }
    throw new UsageException("notSeconds", option, text);
  }

  /** The name of a view. */
  RenderPass view() throws UsageException {
    final StringJoiner names = new StringJoiner(", ");
    for (final RenderPass view : RenderPass.values()) {
      names.add(view.option());
    }
    return RenderPass.named(text()).orElseThrow(() -> new UsageException("unknownView", value, names));
  }

  /** The name of a file. */
  static Path path(final String text) throws UsageException {
    try {
      return Path.of(text);
    } catch (final InvalidPathException noPath) {
      throw LocaleCharset.canExpress(text) ? new UsageException("noPath", text)
          : new UsageException("noPathInLocale", text, LocaleCharset.name());
    }
  }
}
