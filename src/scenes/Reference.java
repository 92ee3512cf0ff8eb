package scenes;

/** What stands between {@code &} and {@code ;}: one of the five entities of XML, or the number of a character. */
final class Reference {

  private Reference() {
  }

  /** The text that a reference of a name stands for; null if there is none of this name. */
  static String meaning(final String name) {
    return switch (name) {
      case "lt" -> "<";
      case "gt" -> ">";
      case "amp" -> "&";
      case "quot" -> "\"";
      case "apos" -> "'";
      default -> name.startsWith("#") ? character(name.substring(1)) : null;
    };
  }

  private static String character(final String number) {
    final boolean hexadecimal = number.startsWith("x");
    final String digits = hexadecimal ? number.substring(1) : number;
    int code = digits.isEmpty() ? -1 : 0;
    for (int i = 0; i < digits.length() && code >= 0; i++) {
      final char c = digits.charAt(i);
      final int digit = c < 128 ? Character.digit(c, hexadecimal ? 16 : 10) : -1;
      code = digit < 0 || code > Character.MAX_CODE_POINT ? -1 : code * (hexadecimal ? 16 : 10) + digit;
    }
    final boolean allowed = code == '\t' || code == '\n' || code == '\r' || code >= ' ' && code < 0xd800
        || code >= 0xe000 && code < 0xfffe || code > 0xffff && code <= Character.MAX_CODE_POINT;
    return allowed ? Character.toString(code) : null;
  }
}
