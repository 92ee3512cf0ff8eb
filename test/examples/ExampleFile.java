package examples;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.function.Supplier;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;

/** The files of the folder {@code scenes} that programs wrote. */
enum ExampleFile {
  TEAPOT("teapot.obj", Teapot::text),
  KNOT("knot.zip", Knot::text),
  SPIRAL("sunflower.xml", Spiral::scene),
  SPONGE("sponge.xml", Sponge::scene),
  HELIX("helix.xml", Helix::text),
  TUNNEL("tunnel.xml", Tunnel::scene),
  ORTHOGRAPHIC("orthographic.xml", Temple::orthographic),
  PERSPECTIVE("perspective.xml", Temple::perspective),
  ANGULAR("angular.xml", Temple::angular),
  EVENING("evening.xml", Temple::evening),
  CHESS("chess.xml", Chess::text),
  CHESSBOARD("chessboard.xml", Chess::lit);

  private final Path path;
  private final Supplier<String> program;

  ExampleFile(final String name, final Supplier<String> program) {
    this.path = Path.of("scenes", name);
    this.program = program;
  }

  Path path() {
    return path;
  }

  private boolean isZipped() {
    return path.toString().endsWith(".zip");
  }

  /** The output of the program. */
  String fromProgram() {
    return program.get();
  }

  /** The contents of the file; of a ZIP file, its first entry. */
  String fromFile() throws IOException {
    if (!isZipped()) {
      return Files.readString(path);
    }
    try (ZipInputStream zip = new ZipInputStream(Files.newInputStream(path))) {
      zip.getNextEntry();
      return new String(zip.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  /** Rewrites the file. */
  void write() throws IOException {
    final byte[] bytes = fromProgram().getBytes(StandardCharsets.UTF_8);
    Files.write(path, isZipped() ? zipped(bytes) : bytes);
  }

  private byte[] zipped(final byte[] bytes) throws IOException {
    final ByteArrayOutputStream result = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(result)) {
      final ZipEntry entry = new ZipEntry(path.getFileName().toString().replace(".zip", ".obj"));
      entry.setLastModifiedTime(FileTime.fromMillis(0));
      zip.putNextEntry(entry);
      zip.write(bytes);
      zip.closeEntry();
    }
    return result.toByteArray();
  }
}
