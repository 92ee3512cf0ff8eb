package documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

import javax.imageio.ImageIO;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The programs of the Spanish page compile without warnings and make the promised picture. */
class LeemeExamplesTest {

  @TempDir
  private Path folder;

  private final Document page;

  LeemeExamplesTest() throws IOException {
    page = new Document("LEEME.md");
  }

  private BufferedImage picture(final String program, final Path into) throws Exception {
    final String disc = page.blocks("java").get(1);
    final Compilation compilation = new Compilation(into).add("Primero.java", program).add("Disco.java", disc);
    compilation.succeeds();
    assertEquals("", compilation.run("Primero"));
    return ImageIO.read(into.resolve("primero.png").toFile());
  }

  @Test
  void theFirstProgramIsLitAndShowsTheDiscOnceItIsAdded() throws Exception {
    final List<String> blocks = page.blocks("java");
    assertEquals(2, blocks.size());
    final BufferedImage without = picture(blocks.get(0), folder.resolve("without"));
    final Color lit = new Color(without.getRGB(340, 150)), shadow = new Color(without.getRGB(180, 260));
    assertTrue(lit.getRed() > lit.getBlue() && lit.getRed() > 100, "the ball is lit: " + lit);
    assertEquals(Color.BLACK, shadow, "the ball's shadow");
    final List<String> calls = page.all("`(escena\\.addObject[^`]+;)`");
    assertEquals(1, calls.size());
    final BufferedImage with = picture(blocks.get(0).replace("    LightGroup", calls.get(0) + "\n    LightGroup"),
        folder.resolve("with"));
    assertNotEquals(without.getRGB(500, 190), with.getRGB(500, 190), "the disc is in the picture");
  }
}
