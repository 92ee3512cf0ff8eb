package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import org.junit.jupiter.api.Test;

/**
 * The report that is handed in was made of its source: {@code ant informe} stores a hash of the source in it. A report that
 * was written with another program has none.
 */
class InformeTest {

  /** In the hand-in the report lies beside the project. */
  private static Path report() {
    final Path here = Path.of("informe.pdf");
    return Files.exists(here) ? here : Path.of("..", "informe.pdf");
  }

  @Test
  void wasMadeOfThisSource() throws Exception {
    assumeTrue(Files.exists(report()), "the project was taken out of the hand-in, without the report");
    final MessageDigest digest = MessageDigest.getInstance("SHA-256");
    for (final String file : List.of("informe.html", "angular.png", "sphere.png", "stilllife.png", "glass.png")) {
      digest.update(Files.readAllBytes(Path.of("doc", "informe", file)));
    }
    final String pdf = new String(Files.readAllBytes(report()), StandardCharsets.ISO_8859_1);
    final Matcher source = Pattern.compile("source ([0-9a-f]{64})").matcher(pdf);
    assumeTrue(source.find(), "informe.pdf was not made by \"ant informe\"");
    assertEquals(HexFormat.of().formatHex(digest.digest()), source.group(1),
        "informe.pdf is older than doc/informe: run \"ant informe\"");
  }
}
