package diagnostics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SimilarFileTest {

  @TempDir
  private Path folder;

  @BeforeEach
  void files() throws IOException {
    Files.createDirectories(folder.resolve("models/pig.xml"));
    Files.createFile(folder.resolve("models/Pig.obj"));
    Files.createFile(folder.resolve("models/cow.xml"));
    Files.createFile(folder.resolve("models/cow.png"));
    Files.createFile(folder.resolve("models/dragon.zip"));
  }

  @ParameterizedTest
  @CsvSource({"models/pig.obj, models/Pig.obj", "Models/PIG.OBJ, models/Pig.obj", "models/cow, models/cow.xml",
      "models/cow.obj, models/cow.xml", "models/Cow.XML, models/cow.xml", "models/dragon.obj, models/dragon.zip",
      "models/dargon.zip, models/dragon.zip"})
  void aNameThatDiffersLittle(final String missing, final String similar) {
    final String question = SimilarFile.question(folder.resolve(missing), ".xml", ".obj", ".zip");
    assertTrue(question.equals(". Did you mean `" + folder.resolve(similar) + "`?"), question);
  }

  @ParameterizedTest
  @CsvSource({"models/elephant.obj", "models/pig.xml.bak", "other/pig.obj", "models/cow.png.png"})
  void aNameLikeNoOther(final String missing) {
    assertEquals("", SimilarFile.question(folder.resolve(missing), ".obj", ".zip"));
  }

  @Test
  void aFolderIsNotMissing() throws IOException {
    Files.createDirectories(folder.resolve("models/cow.obj"));
    assertEquals("", SimilarFile.question(folder.resolve("models/cow.obj"), ".xml", ".png"));
  }

  @Test
  void accentsOfTheOtherNormalForm() throws IOException {
    final String composed = "pr\u00e1ctica.xml", decomposed = "pra\u0301ctica.xml";
    assumeTrue(LocaleCharset.canExpress(composed), LocaleCharset.name());
    Files.createFile(folder.resolve(composed));
    assumeTrue(!Files.exists(folder.resolve(decomposed)), "the file system takes the two for one");
    final String question = SimilarFile.question(folder.resolve(decomposed), ".xml");
    assertTrue(question.contains(composed) && question.contains("look the same"), question);
    assertTrue(SimilarFile.question(folder.resolve("pra\u0301tica.xml"), ".xml").contains("Did you mean"), "mistyped too");
  }

  @Test
  void whatTheLocaleCannotExpress() {
    assertTrue(LocaleCharset.canExpress("plain.xml"));
    assertFalse(LocaleCharset.canExpress("pr\ufffd\ufffdctica.xml"));
  }
}
