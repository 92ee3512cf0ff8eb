package scenes;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/**
 * Feeds the readers with files that something happened to: {@code Fuzz [COUNT [SEED [FOLDER]]]}. Files are changed by
 * bytes, by words and by lines or elements, and read. Whatever is in them, the reader must answer within five seconds, with a message
 * for each problem, at a place that is in the file. A file that breaks this is kept in the folder, by default
 * {@code build/fuzz}; the exit status is 1 then.
 */
final class Fuzz {

  /** A way of changing files. */
  enum Kind {
    SCENE_BYTES, SCENE_WORDS, SCENE_STRUCTURE, OBJ_BYTES, OBJ_WORDS, OBJ_STRUCTURE, ZIP_BYTES;

    boolean isScene() {
      return ordinal() < OBJ_BYTES.ordinal();
    }
  }

  private static final long LONGEST_NANOSECONDS = 5_000_000_000L;

  private static final String[] WORDS = {"0", "-1", "1e30", "1e-30", "1e99", "NaN", "-0", "3.4028235e38", "2147483648",
    "-2147483648", "",
    " ", "0x1p3", "1,5", "255", "true", "<", ">", "&", "&amp;", "<!--", "-->", "<![CDATA[", "]]>", "<!DOCTYPE "
        + "a>", "<?xml?>", "\"", "'",
    "\u0000", "\ufffe", "ñ", "🚀", "\\", "\\\n", "\r", "#", "/", "1/2/3", "-1//-1", "f", "v", "f 1 2 3\n", "v 0 0 0\n"};

  private static final String MESH = "# a square and more\nv 0 0 0\nv 1 0 0 1 1 1\nv 1 1 0\r\nv 0 1 1e-3\nvn 0 0 "
      + "1\nvt 0 0\nf 1 2 3 4\n"
      + "f 1//1 2//1 3//1\nf -4/1 -3/1 \\\n -1/1\ng group\nf 2/1/1 3/1/1 4/1/1\n";

  private final Path folder;
  private final List<String> scenes;

  Fuzz(final Path folder) throws IOException {
    this.folder = Files.createDirectories(folder);
    Files.writeString(folder.resolve("mesh.obj"), MESH);
    try (Stream<Path> files = Files.list(Path.of("scenes"))) {
      scenes = new ArrayList<>();
      for (final Path file : files.filter(path -> path.toString().endsWith(".xml")).sorted().collect(Collectors.toList())) {
        final String text = Files.readString(file);
        if (text.length() < 20_000) {
          scenes.add(text.replaceAll("<objFile>.*?</objFile>", "<objFile>mesh.obj</objFile>"));
        }
      }
    }
    scenes.add(SceneFiles.SOUND);
  }

  public static void main(final String[] args) throws IOException {
    final int count = args.length > 0 ? Integer.parseInt(args[0]) : 2000;
    final long seed = args.length > 1 ? Long.parseLong(args[1]) : System.nanoTime();
    final Fuzz fuzz = new Fuzz(Path.of(args.length > 2 ? args[2] : "build/fuzz"));
    int findings = 0;
    for (final Kind kind : Kind.values()) {
      System.out.println(kind + ": " + count + " files, seed " + seed);
      for (int i = 0; i < count; i++) {
        findings += fuzz.isSound(kind, seed + i) ? 0 : 1;
      }
    }
    System.out.println(findings + " findings");
    System.exit(findings == 0 ? 0 : 1);
  }

  private boolean isSound(final Kind kind, final long seed) throws IOException {
    final String finding = finding(kind, seed);
    if (finding != null) {
      final Path kept = folder.resolve("found-" + kind + "-" + seed);
      Files.write(kept, file(kind, new Random(seed)));
      System.out.println(kept + ": " + finding);
    }
    return finding == null;
  }

  /** What is wrong with the reading of the file of a seed; null if nothing is. */
  String finding(final Kind kind, final long seed) throws IOException {
    final byte[] bytes = file(kind, new Random(seed));
    final Path file = Files.write(folder.resolve(kind.isScene() ? "fuzz.xml" : "fuzz.obj"), bytes);
    final long start = System.nanoTime();
    final List<Problem> problems;
    final boolean sound;
    try {
      if (kind.isScene()) {
        final Reading reading = SceneReader.read(file);
        problems = reading.problems();
        sound = reading.scene().isPresent();
      } else {
        final ObjReader.Reading reading = new ObjReader(file).read();
        problems = reading.problems();
        sound = reading.mesh() != null;
      }
    } catch (final RuntimeException | StackOverflowError | OutOfMemoryError failure) {
      final StackTraceElement[] where = failure.getStackTrace();
      return failure + (where.length > 0 ? " at " + where[0] : "");
    }
    if (System.nanoTime() - start > LONGEST_NANOSECONDS) {
      return "takes longer than five seconds";
    }
    if (sound == problems.stream().anyMatch(Problem::isError)) {
      return "sound: " + sound + ", but " + problems;
    }
    return problems.stream().map(problem -> finding(problem, file,
        bytes)).filter(text -> text != null).findFirst().orElse(null);
  }

  private static String finding(final Problem problem, final Path file, final byte[] bytes) {
    if (problem.message().isBlank() || problem.message().length() > 1000 || problem.message().lines().count() != 1) {
      return "message: " + problem.message();
    }
    if (!problem.file().equals(file.toString())) {
      return null;
    }
    final String text = file.toString().endsWith(".xml") ? Decoding.of(bytes).text() : new String(bytes,
        StandardCharsets.ISO_8859_1);
    final String[] lines = text.split("\r\n|\r|\n", -1);
    final boolean within = problem.line() >= 1 && problem.line() <= lines.length && problem.column() >= 1
        && problem.column() <= lines[problem.line() - 1].length() + 1;
    return within || startsAsZip(bytes) ? null : "place: " + problem;
  }

  private static boolean startsAsZip(final byte[] bytes) {
    return bytes.length > 3 && bytes[0] == 'P' && bytes[1] == 'K';
  }

  /** The file of a seed. */
  private byte[] file(final Kind kind, final Random random) throws IOException {
    final String text = kind.isScene() ? scenes.get(random.nextInt(scenes.size())) : MESH;
    return switch (kind) {
      case SCENE_BYTES, OBJ_BYTES -> bytes(text.getBytes(StandardCharsets.UTF_8), random);
      case SCENE_WORDS, OBJ_WORDS -> words(text, random).getBytes(StandardCharsets.UTF_8);
      case SCENE_STRUCTURE -> pieces(text, "(?=<)", random).getBytes(StandardCharsets.UTF_8);
      case OBJ_STRUCTURE -> pieces(text, "(?<=\n)|(?= )", random).getBytes(StandardCharsets.UTF_8);
      case ZIP_BYTES -> bytes(zip(text), random);
    };
  }

  private static byte[] zip(final String text) throws IOException {
    final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      zip.putNextEntry(new ZipEntry("mesh.obj"));
      zip.write(text.repeat(20).getBytes(StandardCharsets.UTF_8));
    }
    return bytes.toByteArray();
  }

  private static byte[] bytes(final byte[] original, final Random random) {
    byte[] bytes = original;
    for (int i = 1 + random.nextInt(8); i > 0; i--) {
      final int at = random.nextInt(bytes.length);
      if (random.nextInt(20) == 0) {
        bytes = Arrays.copyOf(bytes, Math.max(1, at));
      } else {
        bytes = bytes.clone();
        bytes[at] = (byte) (random.nextBoolean() ? random.nextInt(256) : bytes[at] ^ 1 << random.nextInt(8));
      }
    }
    return bytes;
  }

  private static String words(final String text, final Random random) {
    final String[] words = text.split("(?<=[ \n<>/=\"])|(?=[ \n<>/=\"])");
    for (int i = 1 + random.nextInt(6); i > 0; i--) {
      words[random.nextInt(words.length)] = random.nextInt(3) == 0 ? words[random.nextInt(words.length)]
          : WORDS[random.nextInt(WORDS.length)];
    }
    return String.join("", words);
  }

  private static String pieces(final String text, final String border, final Random random) {
    final List<String> pieces = new ArrayList<>(Arrays.asList(text.split(border)));
    for (int i = 1 + random.nextInt(4); i > 0; i--) {
      final int from = random.nextInt(pieces.size()), length = Math.min(1 + random.nextInt(6), pieces.size() - from);
      final List<String> part = new ArrayList<>(pieces.subList(from, from + length));
      switch (random.nextInt(4)) {
        case 0 -> pieces.subList(from, from + length).clear();
        case 1 -> pieces.addAll(random.nextInt(pieces.size()), part);
        case 2 -> Collections.shuffle(pieces.subList(from, from + length), random);
        default -> pieces.add(from, String.join("", Collections.nCopies(1 + random.nextInt(300), pieces.get(from))));
      }
      if (pieces.isEmpty()) {
        pieces.add(" ");
      }
    }
    return String.join("", pieces);
  }
}
