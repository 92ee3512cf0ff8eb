package upnatray;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import arguments.Messages;

class OptionsTest {

  private static final Path SCENE = Path.of("somewhere", "torus.xml");

  @Test
  void filesAndOptionsInAnyOrder() throws UsageException {
    final Options options = Options.of("a.xml", "--threads", "3", "b.xml", "--no-window", "--check", "--", "--width");
    assertEquals(List.of(Path.of("a.xml"), Path.of("b.xml"), Path.of("--width")), options.scenes());
    assertEquals(3, options.threads());
    assertTrue(options.check());
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', value = {"|640 480", "--width 320|320 240", "--height=240|320 240", "--width 100 "
      + "--height 100|100 100", "--width 1|1 1",
    "--width=2147483647|2147483647 1610612735"})
  void oneSizeAloneKeepsTheProportions(final String args, final String size) throws UsageException {
    final int[] actual = Options.of(args == null ? new String[0] : args.split(" ")).size(640, 480);
    assertEquals(size, actual[0] + " " + actual[1]);
  }

  @Test
  void picturesGoWhereTheyAreAskedTo(@TempDir final Path folder) throws UsageException {
    assertEquals(Path.of("images", "torus.png"), Options.of(SCENE.toString()).target(SCENE));
    assertEquals(Path.of("x.png"), Options.of(SCENE.toString(), "-o", "x.png").target(SCENE));
    assertEquals(Path.of("x", "torus.png"), Options.of(SCENE.toString(), "-o", "x/").target(SCENE));
    assertEquals(folder.resolve("torus.png"), Options.of(SCENE.toString(), "--output=" + folder).target(SCENE));
    assertEquals(Path.of("x", "torus.png"), Options.of(SCENE.toString(), "other.xml", "-o", "x").target(SCENE));
    assertEquals(Path.of("images", "noextension.png"), Options.of("noextension").target(Path.of("noextension")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"--widht 3", "-x", "--width", "--width=", "--width x", "--width 0", "--width -5", "--width "
      + "1e3", "--width 99999999999", "-o",
    "--check=yes a.xml", "--help=1", "--check", "--threads 0",
    "a.xml b.xml --window", "a.xml --window -o b.png", "a.xml --window --check", "a.xml --window --no-window",
    "p/a.xml q/a.xml", "p/a.xml p/a -o x",
    "--turntable 1", "--turntable 10001", "--turntable x", "--turntable", "--seconds 2", "--frames 0-1", "--again",
    "--turntable 8 --frames 0-8", "--turntable 8 --frames 3-2", "--turntable 8 --frames 3", "--turntable 8 --seconds 0.07",
    "--turntable 8 --seconds 0", "--turntable 8 --seconds -1", "--turntable 8 --seconds 2,5",
    "--turntable 8 --seconds 1e400", "--turntable 8 --seconds 999999999", "--turntable 8 --view depth",
    "--turntable 8 --view cost", "--turntable 8 --window",
    "--rows 1-2 --view depth", "--rows 1-2 --view cost", "--adaptive --view depth", "--adaptive --samples 1",
    "--adaptive --window", "--again=yes --turntable 8"})
  void wrongUsageIsTold(final String args) {
    final UsageException wrong = assertThrows(UsageException.class, () -> Options.of(args.split(" ")));
    assertTrue(wrong.getMessage().length() > 10);
  }

  @ParameterizedTest
  @CsvSource({"--sampels, --samples", "--turnable, --turntable", "--widht, --width", "--Frames=1-2, --frames"})
  void aNearOptionIsSuggested(final String wrong, final String right) {
    final String message = assertThrows(UsageException.class, () -> Options.of(wrong, "3")).getMessage();
    assertTrue(message.contains("`" + right + "`"), message);
    assertEquals(Messages.text("upnatray.unknownOption", "--colour-blind", ""),
        assertThrows(UsageException.class, () -> Options.of("--colour-blind")).getMessage());
  }

  @Test
  void anAnimationIsWholeUnlessSomeOfItsPicturesAreWanted() throws UsageException {
    assertTrue(Options.of("a.xml").turntable().isEmpty());
    assertEquals(new Turntable(24, 2, 0, 23, false), Options.of("--turntable", "24").turntable().orElseThrow());
    assertEquals(new Turntable(24, 0.5, 3, 7, true),
        Options.of("--turntable=24", "--frames=3-7", "--seconds", ".5", "--again").turntable().orElseThrow());
  }

  @Test
  void adaptiveSamplesAreFourByFourUnlessOtherwiseSaid() throws UsageException {
    assertEquals(new Resolution(6, 4, 4, true, 0, 4), Options.of("--adaptive").resolution(6, 4));
    assertEquals(new Resolution(6, 4, 3, true, 1, 2),
        Options.of("--adaptive", "--samples", "3", "--rows", "2-3").resolution(6, 4));
    assertEquals(new Resolution(6, 4, 1, false, 0, 4), Options.of().resolution(6, 4));
  }

  @Test
  void scenesThatAreWrittenToNoFileOrAreTheSameMayHaveOneName() throws UsageException {
    assertEquals(2, Options.of("p/a.xml", "q/a.xml", "--check").scenes().size());
    assertEquals(2, Options.of("p/a.xml", "p/a.xml").scenes().size());
  }

  @Test
  void severalPicturesDoNotFitAFile(@TempDir final Path folder) throws Exception {
    final Path file = Files.createFile(folder.resolve("f"));
    assertThrows(UsageException.class, () -> Options.of("a.xml", "b.xml", "-o", file.toString()));
    assertThrows(UsageException.class, () -> Options.of("a.xml", "b.xml", "-o", folder.resolve("both.PNG").toString()));
    assertArrayEquals(new int[] {3, 2}, Options.of("a.xml", "-o", file.toString()).size(3, 2));
  }
}
