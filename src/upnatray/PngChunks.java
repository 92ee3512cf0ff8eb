package upnatray;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32;

/**
 * The chunks of a PNG file, each checked by its CRC. Source: W3C, "Portable Network Graphics (PNG) Specification", third
 * edition, 2025, section 5.
 */
final class PngChunks {

  /** The keyword of the texts that this program writes. */
  static final String KEYWORD = "UPNaTRay";

  static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

  /**
   * A chunk.
   *
   * @param type its four letters
   * @param data what it holds
   */
  record Chunk(String type, byte[] data) {

    /** Writes the chunk with its length and its CRC. */
    void writeTo(final OutputStream stream) throws IOException {
      final byte[] letters = type.getBytes(StandardCharsets.US_ASCII);
      final DataOutputStream out = new DataOutputStream(stream);
      out.writeInt(data.length);
      out.write(letters);
      out.write(data);
      out.writeInt(crc(letters, data));
    }

    /** The program's own text, if the chunk holds that; null otherwise. */
    String text() {
      final String all = "tEXt".equals(type) ? new String(data, StandardCharsets.ISO_8859_1) : "";
      return all.startsWith(KEYWORD + '\0') ? all.substring(KEYWORD.length() + 1) : null;
    }
  }

  private final DataInputStream in;
  private boolean ended;

  /**
   * The chunks of a file.
   *
   * @throws IOException if it is not a PNG file
   */
  PngChunks(final InputStream stream) throws IOException {
    in = new DataInputStream(stream);
    if (!Arrays.equals(in.readNBytes(SIGNATURE.length), SIGNATURE)) {
      throw new IOException("not a PNG file");
    }
  }

  /**
   * The next chunk; null after the last.
   *
   * @throws IOException if the file is damaged or not complete
   */
  Chunk next() throws IOException {
    if (ended) {
      return null;
    }
    final int length = in.readInt();
    final byte[] letters = in.readNBytes(Integer.BYTES);
    final byte[] data = in.readNBytes(Math.max(0, length));
    if (data.length != length || in.readInt() != crc(letters, data)) {
      throw new IOException("damaged PNG file");
    }
    final String type = new String(letters, StandardCharsets.US_ASCII);
    ended = "IEND".equals(type);
    return new Chunk(type, data);
  }

  private static int crc(final byte[] letters, final byte[] data) {
    final CRC32 crc = new CRC32();
    crc.update(letters);
    crc.update(data);
    return (int) crc.getValue();
  }

  /** A chunk of whole numbers of four bytes, followed by others of two bytes and of one. */
  static Chunk of(final String type, final int[] ints, final int[] shorts, final int... bytes) throws IOException {
    final ByteArrayOutputStream data = new ByteArrayOutputStream();
    final DataOutputStream out = new DataOutputStream(data);
    for (final int number : ints) {
      out.writeInt(number);
    }
    for (final int number : shorts) {
      out.writeShort(number);
    }
    for (final int number : bytes) {
      out.writeByte(number);
    }
    return new Chunk(type, data.toByteArray());
  }
}
