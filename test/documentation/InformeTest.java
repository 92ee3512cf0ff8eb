package documentation;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;

import org.junit.jupiter.api.Test;

/** The report that is handed in was made of its source: {@code ant informe} stores a hash of the source in it. */
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
    final String source = "source " + HexFormat.of().formatHex(digest.digest());
    final String pdf = new String(Files.readAllBytes(report()), StandardCharsets.ISO_8859_1);
    assertTrue(pdf.contains(source), "informe.pdf is older than doc/informe: run \"ant informe\"");
  }
}
