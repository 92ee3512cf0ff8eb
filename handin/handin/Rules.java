package handin;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import org.apache.pdfbox.Loader;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.text.PDFTextStripper;

/** The rules that the assignment makes for what is handed in. */
final class Rules {

  static final String NAME = "UPNaTRay";

  private static final int PAGES = 3;
  private static final List<String> NEEDED = List.of("build.xml", "ant/libraries.xml", "ant/program.xml", "ant/test.xml",
      "ant/quality.xml", "ant/handin.xml", "ivy.xml", "nbproject/project.properties", "nbproject/project.xml",
      "lib/build.retrieved");
  private static final Pattern PROJECT_NAME = Pattern.compile("<name>\\s*([^<]*?)\\s*</name>");
  private static final Pattern LIBRARY = Pattern.compile("\\blib/(compile|test)/[\\w.-]+\\.jar");
  private static final int WORDS = Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE;
  private static final Pattern PROBLEMS = Pattern.compile("problema", WORDS);
  private static final Pattern SOLUTIONS = Pattern.compile("soluci[oó]n", WORDS);
  private static final Pattern HOURS = Pattern.compile("\\d\\s*(h\\b|horas)", WORDS);

  private final Path project;
  private final List<String> paths;
  private final Path report;
  private final List<String> broken = new ArrayList<>();

  Rules(final Path project, final List<String> paths, final Path report) {
    this.project = project;
    this.paths = paths;
    this.report = report;
  }

  /** Every rule that is broken, in words; none if all is well. */
  List<String> broken() throws IOException {
    broken.clear();
    checkProject();
    checkClasses();
    checkReport();
    return List.copyOf(broken);
  }

  private void rule(final boolean kept, final String name, final String wrong) {
    if (!kept) {
      broken.add(name + ": " + wrong);
    }
  }

  private void checkProject() throws IOException {
    for (final String path : NEEDED) {
      rule(paths.contains(path), "complete project", path + " is missing");
    }
    final Path settings = project.resolve("nbproject/project.xml");
    final Matcher name = PROJECT_NAME.matcher(Files.exists(settings) ? Files.readString(settings) : "");
    final String found = name.find() ? name.group(1) : "";
    rule(NAME.equals(found), "project name", "nbproject/project.xml calls the project \"" + found + "\", not " + NAME);
    checkLibraries();
  }

  /** Without them the project would need the network where it is marked. */
  private void checkLibraries() throws IOException {
    final Path settings = project.resolve("nbproject/project.properties");
    final Matcher library = LIBRARY.matcher(Files.exists(settings) ? Files.readString(settings) : "");
    while (library.find()) {
      rule(paths.contains(library.group()), "libraries", library.group() + " is missing; \"ant\" fetches it");
    }
  }

  private void checkClasses() {
    for (final String path : paths) {
      rule(!path.endsWith(".class"), "no compiled class", path + " is one; delete it");
    }
  }

  private void checkReport() throws IOException {
    if (!Files.isRegularFile(report)) {
      rule(false, "informe.pdf", "there is none; \"ant informe\" makes it from doc/informe");
      return;
    }
    try (PDDocument document = Loader.loadPDF(report.toFile())) {
      final int pages = document.getNumberOfPages();
      rule(pages <= PAGES, "informe.pdf", "it has " + pages + " pages; " + PAGES + " are allowed");
      final String text = words(new PDFTextStripper().getText(document));
      rule(PROBLEMS.matcher(text).find(), "informe.pdf", "it names no problem (\"problema\")");
      rule(SOLUTIONS.matcher(text).find(), "informe.pdf", "it names no solution (\"solución\")");
      rule(HOURS.matcher(text).find(), "informe.pdf", "it does not give the hours (such as \"30 horas\")");
    } catch (IOException unreadable) {
      rule(false, "informe.pdf", "it cannot be read: " + unreadable.getMessage());
    }
  }

  /** Text whose words are not divided at the ends of lines. */
  private static String words(final String text) {
    return text.replaceAll("[-\u00ad\u2010]\\s*\\R", "");
  }
}
