package meshes;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import arguments.Messages;
import diagnostics.Problem;

/**
 * Reads a mesh from a Wavefront OBJ text file, or from a ZIP file whose first entry is one (folders aside).
 *
 * <p>Vertices ({@code v}) and facets ({@code f}) count; other statements are passed over line by line, normals and texture
 * coordinates among them, as triangles have no use for them yet. A facet of any number of corners becomes a fan of
 * triangles. An index counts from 1, or, if negative, back from the vertex that was read last; it must name a vertex that
 * stands before it in the file. Facets without area are dropped. Colours after the coordinates of a vertex are passed over.
 */
public final class ObjReader {

  /** After so many errors the rest of a file is not looked at. */
  static final int MOST_ERRORS = 20;

  /** More digits than this are no number of a vertex. */
  private static final int MOST_DIGITS = 18;

  /**
   * A mesh as arrays.
   *
   * @param coordinates x, y and z of each vertex
   * @param corners three numbers of vertices, from 0, for each triangle
   */
  public record Mesh(float[] coordinates, int[] corners) {
  }

  /**
   * What was read of a file.
   *
   * @param mesh the mesh; null if there is an error
   * @param problems what is wrong with it, in the order of the file
   */
  public record Result(Mesh mesh, List<Problem> problems) {
  }

  private final Path file;
  private final List<Problem> problems = new ArrayList<>();
  private final DecimalParser decimals = new DecimalParser();
  private final TriangleBuffer triangles = new TriangleBuffer();
  private ByteReader bytes;
  private int line = 1;
  private long lineStart;
  private int errors;

  /**
   * A reader of a file.
   *
   * @param file the file
   */
  public ObjReader(final Path file) {
    this.file = file;
  }

  /**
   * Reads the file, once.
   *
   * @return its mesh and its problems
   */
  public Result read() {
    try (InputStream in = Files.newInputStream(file)) {
      readFrom(in);
    } catch (final ByteReader.TooLongException tooLong) {
      whole("zipTooLong", ZippedMesh.LARGEST >> 30);
    } catch (final IOException failure) {
      whole("unreadable", failure.getClass().getSimpleName() + ": " + failure.getMessage());
    }
    triangles.settle();
    if (errors == 0 && triangles.isEmpty()) {
      whole(triangles.dropped() > 0 ? "noArea" : "noFacet", triangles.dropped());
    } else if (errors == 0 && triangles.dropped() > 0) {
      problems.add(new Problem(file.toString(), triangles.firstDroppedLine(), 1, Problem.Severity.WARNING,
          Messages.text("meshes.dropped", triangles.dropped())));
    }
    return new Result(errors > 0 ? null : triangles.mesh(), problems);
  }

  private void readFrom(final InputStream in) throws IOException {
    bytes = new ByteReader(in, Long.MAX_VALUE);
    bytes.reserve();
    if (startsWith(0x50, 0x4b, 0x03, 0x04)) {
      readZip();
    } else {
      readText();
    }
  }

  private void readZip() throws IOException {
    try (InputStream entry = ZippedMesh.open(file)) {
      if (entry == null) {
        whole("zipEmpty");
        return;
      }
      bytes = new ByteReader(entry, ZippedMesh.LARGEST);
      bytes.reserve();
      readText();
    }
  }

  private void readText() throws IOException {
    if (startsWith(0xef, 0xbb, 0xbf)) {
      bytes.at = 3;
    }
    while (!bytes.isAtEnd() && errors < MOST_ERRORS) {
      statement();
    }
    if (errors == MOST_ERRORS) {
      error(lineStart, "tooManyErrors", MOST_ERRORS);
    }
  }

  private boolean startsWith(final int... start) {
    for (int i = 0; i < start.length; i++) {
      if ((bytes.window[i] & 0xff) != start[i]) {
        return false;
      }
    }
    return true;
  }

  /** Reads a line, or more if they are continued, up to the start of the next. */
  private void statement() throws IOException {
    if (!toWord()) {
      endLine();
      return;
    }
    final byte first = bytes.window[bytes.at];
    final boolean single = isBlank(bytes.window[bytes.at + 1]) || continues(bytes.at + 1);
    if (first == 'v' && single) {
      bytes.at++;
      vertex();
    } else if (first == 'f' && single) {
      bytes.at++;
      facet();
    } else {
      skipLine(first != '#');
      return;
    }
    skipLine(true);
  }

  private void vertex() throws IOException {
    final long start = bytes.position();
    final float x = coordinate(start);
    final float y = Float.isNaN(x) ? x : coordinate(start);
    final float z = Float.isNaN(y) ? y : coordinate(start);
    // A vertex at fault keeps its number, so that the facets after it are not at fault too.
    triangles.vertex(x, y, z);
  }

  /** The next number of a vertex; NaN, and told, if there is none. */
  private float coordinate(final long start) throws IOException {
    if (!toWord()) {
      error(start - 1, "vertexShort");
      return Float.NaN;
    }
    final float number = decimals.parse(bytes.window, bytes.at);
    final int end = decimals.end();
    if (end == bytes.at || !endsWord(end) || !Float.isFinite(number)) {
      error(bytes.position(), end > bytes.at && endsWord(end) ? "coordinateLarge" : "notCoordinate", word());
      return Float.NaN;
    }
    bytes.at = end;
    return number;
  }

  private void facet() throws IOException {
    final long start = bytes.position() - 1;
    final int facetLine = line;
    int first = -1;
    int last = -1;
    int corners = 0;
    while (toWord()) {
      final int vertex = corner();
      if (vertex < 0) {
        return;
      }
      corners++;
      if (corners > 2) {
        triangles.triangle(first, last, vertex, facetLine);
      }
      first = corners == 1 ? vertex : first;
      last = vertex;
    }
    if (corners < 3) {
      error(facetLine, start, "facetShort", corners);
    }
  }

  /** The next corner of a facet, {@code i}, {@code i/t}, {@code i//n} or {@code i/t/n}: its vertex; −1 if it is none. */
  private int corner() {
    final byte[] window = bytes.window;
    int i = bytes.at;
    final boolean negative = window[i] == '-';
    if (negative || window[i] == '+') {
      i++;
    }
    final int digits = i;
    long index = 0;
    for (int digit = window[i] - '0'; digit >= 0 && digit <= 9; digit = window[++i] - '0') {
      index = 10 * index + digit;
    }
    final boolean none = i == digits || i - digits > MOST_DIGITS;
    while (window[i] >= '/' && window[i] <= '9' || window[i] == '-') {
      i++;
    }
    if (none || !endsWord(i)) {
      error(bytes.position(), "notCorner", word());
      return -1;
    }
    final long vertex = negative ? triangles.vertices() - index : index - 1;
    if (vertex < 0 || vertex >= triangles.vertices()) {
      error(bytes.position(), "noVertex", (negative ? "-" : "") + index, triangles.vertices());
      return -1;
    }
    bytes.at = i;
    return (int) vertex;
  }

  /** Goes to the next word of the statement, over blanks and continued line ends; false if there is none. */
  private boolean toWord() throws IOException {
    while (true) {
      bytes.reserve();
      final byte[] window = bytes.window;
      final int last = bytes.at + ByteReader.LONGEST - 2;
      int i = bytes.at;
      while (i < last && (window[i] == ' ' || window[i] == '\t')) {
        i++;
      }
      bytes.at = i;
      if (window[i] == '\\' && continues(i)) {
        bytes.at++;
        endLine();
      } else if (i < last) {
        return window[i] != '\n' && window[i] != '\r' && window[i] != '#';
      }
    }
  }

  /** Whether a byte is a backslash at the end of its line. */
  private boolean continues(final int i) {
    final byte next = bytes.window[i + 1];
    return bytes.window[i] == '\\' && (next == '\n' || next == '\r') && !bytes.isAtEnd();
  }

  private static boolean isBlank(final byte b) {
    return b == ' ' || b == '\t' || b == '\n' || b == '\r';
  }

  private boolean endsWord(final int i) {
    return isBlank(bytes.window[i]) && !bytes.isCut(i) || bytes.window[i] == '#' || continues(i);
  }

  /** Passes over the rest of a line, and over the lines that continue it if they may. */
  private void skipLine(final boolean continued) throws IOException {
    while (true) {
      bytes.reserve();
      final byte[] window = bytes.window;
      final int last = bytes.at + ByteReader.LONGEST - 2;
      int i = bytes.at;
      while (i < last && window[i] != '\n' && window[i] != '\r') {
        i++;
      }
      bytes.at = i;
      if (i < last) {
        final boolean more = continued && i > 0 && window[i - 1] == '\\' && !bytes.isAtEnd();
        endLine();
        if (!more) {
          return;
        }
      }
    }
  }

  /** Passes over the end of a line: a line feed, a carriage return, or both in this order. */
  private void endLine() throws IOException {
    if (bytes.isAtEnd()) {
      return;
    }
    if (bytes.window[bytes.at] == '#') {
      skipLine(false);
      return;
    }
    bytes.at += bytes.window[bytes.at] == '\r' && bytes.window[bytes.at + 1] == '\n' ? 2 : 1;
    line++;
    lineStart = bytes.position();
  }

  /** The word that begins here, fit for a message. */
  private String word() {
    int end = bytes.at;
    while (end < bytes.at + 2 * Messages.LONGEST_QUOTE && !isBlank(bytes.window[end])) {
      end++;
    }
    return Messages.quote(new String(bytes.window, bytes.at, end - bytes.at, StandardCharsets.UTF_8));
  }

  private void error(final long position, final String key, final Object... parts) {
    error(line, position, key, parts);
  }

  private void error(final int at, final long position, final String key, final Object... parts) {
    final int column = at == line ? (int) Math.max(1, Math.min(position - lineStart + 1, Integer.MAX_VALUE)) : 1;
    errors++;
    problems.add(new Problem(file.toString(), at, column, Problem.Severity.ERROR, Messages.text("meshes." + key, parts)));
  }

  /** An error of the file as a whole. */
  private void whole(final String key, final Object... parts) {
    errors++;
    problems.add(new Problem(file.toString(), 1, 1, Problem.Severity.ERROR, Messages.text("meshes." + key, parts)));
  }
}
