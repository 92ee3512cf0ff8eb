package documentation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The README, and what can be asked of it. */
final class Readme {

  private final String text;

  Readme() throws IOException {
    text = Files.readString(Path.of("README.md"));
  }

  /** What the groups of a pattern match, one text for each match. */
  List<String> all(final String pattern) {
    return Pattern.compile(pattern, Pattern.MULTILINE).matcher(text).results()
        .map(Readme::group).collect(Collectors.toList());
  }

  private static String group(final MatchResult match) {
    return match.group(1);
  }

  /** The blocks of a language, without their fences. */
  List<String> blocks(final String language) {
    return all("^```" + language + "\\n([\\s\\S]*?)^```$");
  }

  /** The Java source that defines a public class. */
  String source(final String className) {
    return blocks("java").stream().filter(block -> block.contains("public class " + className + " "))
        .findFirst().orElseThrow(() -> new AssertionError("the README has no class " + className));
  }
}
