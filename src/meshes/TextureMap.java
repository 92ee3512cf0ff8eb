package meshes;

import java.util.List;
import java.util.regex.Pattern;

/**
 * What stands after {@code map_Kd}: options, which are passed over with their arguments, and the name of an image, which may
 * hold blanks. An option of another name has one argument, if a name is left after that.
 *
 * @param file the name
 * @param isMoved whether an option would move, scale or disturb the texture
 */
record TextureMap(String file, boolean isMoved) {

  private static final Pattern NUMBER = Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");
  private static final List<String> OPTIONS = List.of("-blendu", "-blendv", "-boost", "-bm", "-cc", "-clamp", "-imfchan",
      "-texres", "-type", "-colorspace");

  static TextureMap of(final String statement) {
    String rest = statement;
    boolean moved = false;
    while (true) {
      final String option = word(rest);
      if (option.equals("-o") || option.equals("-s") || option.equals("-t")) {
        rest = behind(rest);
        for (int i = 0; i < 3 && NUMBER.matcher(word(rest)).matches() && !behind(rest).isEmpty(); i++) {
          moved |= Double.parseDouble(word(rest)) != (option.equals("-s") ? 1 : 0);
          rest = behind(rest);
        }
      } else if (option.equals("-mm")) {
        rest = behind(behind(behind(rest)));
      } else if (option.startsWith("-") && (OPTIONS.contains(option) || !behind(behind(rest)).isEmpty())) {
        rest = behind(behind(rest));
      } else {
        return new TextureMap(rest, moved);
      }
    }
  }

  private static String word(final String text) {
    return text.split("[ \t]", 2)[0];
  }

  private static String behind(final String text) {
    final String[] words = text.split("[ \t]+", 2);
    return words.length < 2 ? "" : words[1];
  }
}
