package meshes;

import java.io.IOException;
import java.util.Arrays;

/**
 * Reads the corners of a facet: {@code i}, {@code i/t}, {@code i//n} or {@code i/t/n}, where each index counts from 1,
 * or, if negative, back from the last of its kind. What follows the vertex is ignored if it is invalid.
 */
final class FacetReader {

  /** An index has at most this many digits. */
  private static final int MOST_DIGITS = 18;

  /** The outcome of reading a facet. */
  enum Outcome {
    /** Three corners or more. */
    SOUND,
    /** Fewer than three corners. */
    SHORT,
    /** The text at the current place is not a corner. */
    NOT_CORNER,
    /** A corner names a vertex that does not exist. */
    NO_VERTEX
  }

  private final ObjText text;
  private final CornerAttributes attributes;
  private int[] vertices = new int[16];
  private int[] normals = new int[16];
  private int[] texCoords = new int[16];
  private int size;
  private boolean hasNormals;
  private boolean hasTexCoords;
  private boolean lacksTexCoords;

  /** The last index read, and where its digits end. */
  private long index;
  private int end;

  FacetReader(final ObjText text, final CornerAttributes attributes) {
    this.text = text;
    this.attributes = attributes;
  }

  /** Reads the corners up to the end of the statement. */
  Outcome read(final int vertexCount) throws IOException {
    size = 0;
    hasNormals = false;
    hasTexCoords = false;
    lacksTexCoords = false;
    while (text.toWord()) {
      if (size == vertices.length) {
        vertices = Arrays.copyOf(vertices, 2 * size);
        normals = Arrays.copyOf(normals, 2 * size);
        texCoords = Arrays.copyOf(texCoords, 2 * size);
      }
      final Outcome outcome = corner(vertexCount);
      if (outcome != Outcome.SOUND) {
        return outcome;
      }
    }
    return size < 3 ? Outcome.SHORT : Outcome.SOUND;
  }

  private Outcome corner(final int vertexCount) {
    final byte[] window = text.bytes.window;
    final int start = text.bytes.at;
    if (!index(start) || !endsAfter(end)) {
      return Outcome.NOT_CORNER;
    }
    final long vertex = index < 0 ? vertexCount + index : index - 1;
    if (vertex < 0 || vertex >= vertexCount) {
      return Outcome.NO_VERTEX;
    }
    vertices[size] = (int) vertex;
    texCoords[size] = MeshBuilder.NONE;
    normals[size] = MeshBuilder.NONE;
    if (window[end] == '/') {
      texCoords[size] = attribute(attributes.texCoordCount());
      hasTexCoords |= texCoords[size] >= 0;
      lacksTexCoords |= !attributes.isTexCoord(texCoords[size]);
      if (window[end] == '/') {
        normals[size] = attribute(attributes.normalCount());
        hasNormals |= normals[size] >= 0;
      }
    }
    lacksTexCoords |= texCoords[size] < 0;
    size++;
    text.bytes.at = endOfWord(end);
    return Outcome.SOUND;
  }

  /** Reads a whole number, perhaps with a sign; false if none. */
  private boolean index(final int start) {
    final byte[] window = text.bytes.window;
    int i = start;
    final boolean negative = window[i] == '-';
    i += isSign(window[i]) ? 1 : 0;
    final int digits = i;
    index = 0;
    for (int digit = window[i] - '0'; digit >= 0 && digit <= 9; digit = window[++i] - '0') {
      index = 10 * index + digit;
    }
    // So a lone minus sign names none, as does an empty index.
    index = negative && index == 0 ? Long.MIN_VALUE / 2 : negative ? -index : index;
    end = i;
    return i > digits && i - digits <= MOST_DIGITS;
  }

  /** Reads the index after a slash; counts it as missing if it is given but invalid. */
  private int attribute(final int count) {
    final byte[] window = text.bytes.window;
    final int start = end + 1;
    final boolean isNumber = index(start);
    if (end == start && (window[end] == '/' || text.endsWord(end))) {
      return MeshBuilder.NONE;
    }
    final long number = index < 0 ? count + index : index - 1;
    if (!isNumber || number < 0 || number >= count) {
      attributes.miss(text.line());
      return MeshBuilder.NONE;
    }
    return (int) number;
  }

  private int endOfWord(final int from) {
    int i = from;
    while (text.bytes.window[i] >= '/' && text.bytes.window[i] <= '9' || isSign(text.bytes.window[i])) {
      i++;
    }
    return i;
  }

  private static boolean isSign(final byte b) {
    return b == '-' || b == '+';
  }

  /** Whether the word ends properly, whatever digits, slashes and signs stand before its end. */
  private boolean endsAfter(final int from) {
    return text.endsWord(endOfWord(from));
  }

  /** The index of the corner at fault, as it was read. */
  String index() {
    return index == Long.MIN_VALUE / 2 ? "-0" : String.valueOf(index);
  }

  int size() {
    return size;
  }

  int[] vertices() {
    return vertices;
  }

  int[] normals() {
    return normals;
  }

  int[] texCoords() {
    return texCoords;
  }

  boolean hasNormals() {
    return hasNormals;
  }

  boolean hasTexCoords() {
    return hasTexCoords;
  }

  /** Whether a corner has no texture coordinates. */
  boolean lacksTexCoords() {
    return lacksTexCoords;
  }
}
