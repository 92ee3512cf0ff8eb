package meshes;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import diagnostics.Problem;
import diagnostics.UnusualBlank;

/**
 * Reads a mesh from a Wavefront OBJ text file, or from a ZIP file that contains one.
 *
 * <p>Vertices ({@code v}), normals ({@code vn}), texture coordinates ({@code vt}), facets ({@code f}) and the names of
 * materials count; other statements are skipped. All numbers are in double precision. A facet of more than three corners
 * is cut into triangles, see {@link PolygonTriangulator}. An index counts from 1, or, if negative, back from the last of
 * its kind, and must name an element before it in the file. Triangles without area are left out.
 */
public final class ObjReader {

  /** Number of errors after which the rest of a file is not read. */
  static final int MOST_ERRORS = 20;

  private static final Pattern STATEMENT = Pattern.compile(" *(v|vn|vt|f) ");

  /** Number of self-intersecting polygons that are reported individually. */
  private static final int MOST_CROSSINGS = 20;

  /**
   * The result of reading a file.
   *
   * @param mesh the mesh; null if there is an error
   * @param problems its problems, in the order of the file
   * @param large the first coordinate that no float holds, which is an error unless the mesh is placed elsewhere; null if
   *     there is none
   */
  public record Result(ObjMesh mesh, List<Problem> problems, Problem large) {
  }

  private final Path file;
  private final ObjProblems problems;
  private final DecimalParser decimals = new DecimalParser();
  private final CornerAttributes attributes = new CornerAttributes();
  private final ObjMaterials materials = new ObjMaterials();
  private final MeshBuilder mesh;
  private ObjText text;
  private FacetReader facets;
  private int crossings;
  private int curves;
  private int points;
  private boolean broken;
  private Problem large;

  /**
   * A reader of a file.
   *
   * @param file the file
   * @param averaged whether averages of the facets' normals will be needed
   */
  public ObjReader(final Path file, final boolean averaged) {
    this.file = file;
    this.problems = new ObjProblems(file.toString());
    this.mesh = new MeshBuilder(averaged);
  }

  /**
   * Reads the file, once.
   *
   * @return its mesh and its problems
   */
  public Result read() {
    try (BufferedInputStream in = new BufferedInputStream(Files.newInputStream(file))) {
      readFrom(in);
    } catch (final ByteReader.TooLongException tooLong) {
      problems.whole("zipTooLong", ZippedMesh.LARGEST >> 30);
    } catch (final NoSuchFileException missing) {
      problems.missing(file);
    } catch (final IOException failure) {
      problems.whole("unreadable", failure.getClass().getSimpleName() + ": " + failure.getMessage());
    }
    mesh.settle();
    if (!problems.hasErrors() && mesh.isEmpty()) {
      empty();
    } else if (!problems.hasErrors()) {
      warnings();
    }
    return new Result(problems.hasErrors() ? null : mesh.mesh(attributes, materials), problems.all(), large);
  }

  private void empty() {
    if (mesh.dropped() > 0) {
      problems.whole("noArea", mesh.dropped());
    } else if (curves + points > 0) {
      problems.whole("onlyCurves", curves, points);
    } else if (mesh.vertices() > 0) {
      problems.whole("onlyVertices", mesh.vertices());
    } else {
      problems.whole("noFacet");
    }
  }

  private void warnings() {
    if (crossings > MOST_CROSSINGS) {
      problems.warning(1, "moreCrossings", crossings - MOST_CROSSINGS);
    }
    if (attributes.missing() > 0) {
      problems.warning(attributes.firstMissingLine(), "attributesMissing", attributes.missing());
    }
    if (mesh.dropped() > 0) {
      problems.warning(mesh.firstDroppedLine(), "dropped", mesh.dropped());
    }
  }

  private void readFrom(final BufferedInputStream in) throws IOException {
    in.mark(ZippedMesh.MARK);
    final byte[] start = in.readNBytes(ZippedMesh.MARK);
    in.reset();
    if (ZippedMesh.isZip(start)) {
      readZip();
    } else {
      readText(in, Long.MAX_VALUE);
    }
  }

  private void readZip() throws IOException {
    final ZippedMesh entry = ZippedMesh.open(file);
    if (entry == null) {
      problems.whole("zipEmpty");
      return;
    }
    try (InputStream in = entry.stream()) {
      problems.setFile(file + "!" + entry.name());
      readText(new BufferedInputStream(in), ZippedMesh.LARGEST);
    }
  }

  private void readText(final BufferedInputStream in, final long most) throws IOException {
    text = new ObjText(new ByteReader(TextEncoding.decoded(in), most));
    facets = new FacetReader(text, attributes);
    text.bytes.reserve();
    while (!text.isAtEnd() && problems.errors() < MOST_ERRORS) {
      statement();
    }
    if (!text.isAtEnd()) {
      problems.error(text, text.lineStart(), "tooManyErrors", MOST_ERRORS);
    }
  }

  /** Reads a line, or more if they are continued, up to the start of the next. */
  private void statement() throws IOException {
    if (!text.toWord()) {
      text.endLine();
      return;
    }
    final byte first = text.bytes.window[text.bytes.at];
    if (first == 'v') {
      vertexData();
    } else if (first == 'f' && text.takeWord("f")) {
      facet();
    } else if (first == 'u' && text.takeWord("usemtl")) {
      mesh.use(materials.use(text.name(), text.line()));
    } else if (first == 'm' && text.takeWord("mtllib")) {
      materials.library(text.name(), text.line());
    } else {
      other(first);
    }
    text.skipLine(first != '#');
  }

  private void vertexData() throws IOException {
    if (text.takeWord("v")) {
      vertex();
    } else if (text.takeWord("vn")) {
      final double x = number(), y = number(), z = number();
      attributes.normal(x, y, z);
      countBroken();
    } else if (text.takeWord("vt")) {
      final double u = number(), v = text.toWord() ? number() : 0;
      attributes.texCoord(u, v);
      countBroken();
    } else {
      other((byte) 'v');
    }
  }

  private void countBroken() {
    if (broken) {
      attributes.miss(text.line());
    }
    broken = false;
  }

  /** The next number of a normal or a texture coordinate; NaN if none, or if it is not finite. */
  private double number() throws IOException {
    if (!broken && text.toWord()) {
      final double number = decimals.parse(text.bytes.window, text.bytes.at);
      final int end = decimals.end();
      if (end > text.bytes.at && text.endsWord(end) && Double.isFinite(number)) {
        text.bytes.at = end;
        return number;
      }
    }
    broken = true;
    return Double.NaN;
  }

  private void vertex() throws IOException {
    final long start = text.bytes.position();
    final double x = coordinate(start);
    final double y = Double.isNaN(x) ? x : coordinate(start);
    final double z = Double.isNaN(y) ? y : coordinate(start);
    // An invalid vertex keeps its number, so that later facets are not reported too.
    mesh.vertex(x, y, z);
  }

  /** The next number of a vertex; NaN, and reported, if there is none. */
  private double coordinate(final long start) throws IOException {
    if (!text.toWord()) {
      problems.error(text, start - 1, "vertexShort");
      return Double.NaN;
    }
    final double number = decimals.parse(text.bytes.window, text.bytes.at);
    final int end = decimals.end();
    if (end == text.bytes.at || !text.endsWord(end)) {
      wrongWord("notCoordinate");
      return Double.NaN;
    }
    if (!Float.isFinite((float) number)) {
      large = large != null ? large : problems.large(text, Float.MAX_VALUE);
      if (!Double.isFinite(number)) {
        problems.add(problems.large(text, Double.MAX_VALUE));
        return Double.NaN;
      }
    }
    text.bytes.at = end;
    return number;
  }

  private void facet() throws IOException {
    final long start = text.bytes.position() - 1;
    final int line = text.line();
    switch (facets.read(mesh.vertices())) {
      case SOUND -> {
        if (!mesh.facet(facets, line) && !problems.hasErrors() && crossings++ < MOST_CROSSINGS) {
          problems.warning(line, "crossing", facets.size());
        }
      }
      case SHORT -> problems.error(text, line, start, "facetShort", facets.size());
      case NO_VERTEX -> problems.error(text, text.bytes.position(), "noVertex", facets.index(), mesh.vertices());
      default -> wrongWord("notCorner");
    }
  }

  /** Another statement, which is skipped, unless a character in it only looks like a blank. */
  private void other(final byte first) throws IOException {
    if (first == 'l' || first == 'c' || first == 's' || first == 'p') {
      points += text.takeWord("p") ? 1 : 0;
      curves += text.takeWord("l") || text.takeWord("curv") || text.takeWord("curv2") || text.takeWord("surf") ? 1 : 0;
    } else if (first == 'v' || first == 'f' || first < 0) {
      unusualBlank(text.rawLine());
    }
  }

  /** Reports an unusual blank within or before the name of a statement that would be valid without it. */
  private void unusualBlank(final String start) throws IOException {
    final int at = UnusualBlank.indexIn(start);
    final Matcher statement = STATEMENT.matcher(UnusualBlank.replaced(start));
    if (at >= 0 && statement.lookingAt() && at <= statement.end(1)) {
      final String kind = statement.group(1);
      problems.unusualBlank(text, start, at, kind.length() > 1);
      if (kind.equals("v")) {
        mesh.vertex(Double.NaN, Double.NaN, Double.NaN);
      } else if (kind.equals("vn")) {
        attributes.normal(0, 0, 0);
      } else if (kind.equals("vt")) {
        attributes.texCoord(Double.NaN, Double.NaN);
      }
    }
  }

  /** Reports the word that begins here, or the character in it that only looks like a blank. */
  private void wrongWord(final String key) {
    final String word = text.rawWord();
    final int at = UnusualBlank.indexIn(word);
    if (at >= 0) {
      problems.unusualBlank(text, word, at, false);
    } else {
      problems.error(text, text.bytes.position(), key, text.word());
    }
  }
}
