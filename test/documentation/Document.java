package documentation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** A text of the project, such as the README, and queries about it. */
final class Document {

  private final String text;

  Document(final String name) throws IOException {
    text = Files.readString(Path.of(name));
  }

  /** The first group of each match of a pattern. */
  List<String> all(final String pattern) {
    return Pattern.compile(pattern, Pattern.MULTILINE).matcher(text).results()
        .map(Document::group).collect(Collectors.toList());
  }

  private static String group(final MatchResult match) {
    return match.group(1);
  }

  /** The blocks of a language, without their fences. */
  List<String> blocks(final String language) {
    return all("^```" + language + "\\n([\\s\\S]*?)^```$");
  }
}
