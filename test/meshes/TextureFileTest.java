package meshes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;

import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import materials.Texture;

class TextureFileTest {

  @TempDir
  Path folder;

  private static void chunk(final DataOutputStream out, final String type, final int... bytes) throws IOException {
    final byte[] content = new byte[type.length() + bytes.length];
    System.arraycopy(type.getBytes(StandardCharsets.ISO_8859_1), 0, content, 0, type.length());
    for (int i = 0; i < bytes.length; i++) {
      content[type.length() + i] = (byte) bytes[i];
    }
    final CRC32 checksum = new CRC32();
    checksum.update(content);
    out.writeInt(bytes.length);
    out.write(content);
    out.writeInt((int) checksum.getValue());
  }

  /** A PNG image of one row: all greys of a depth, from black to white, one of which is transparent. */
  private static byte[] greys(final int depth, final int transparent) throws IOException {
    final ByteArrayOutputStream row = new ByteArrayOutputStream(), bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes); DeflaterOutputStream deflater = new DeflaterOutputStream(row)) {
      final int greys = 1 << depth;
      deflater.write(0);
      for (int i = 0; i < greys; i += 8 / depth) {
        int packed = 0;
        for (int k = 0; k < 8 / depth; k++) {
          packed = packed << depth | (i + k) % greys;
        }
        deflater.write(packed);
      }
      deflater.finish();
      out.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
      chunk(out, "IHDR", 0, 0, greys >> 8, greys, 0, 0, 0, 1, depth, 0, 0, 0, 0);
      chunk(out, "tEXt", 'a', 0, 'b');
      chunk(out, "tRNS", 0, transparent);
      final byte[] packed = row.toByteArray();
      final int[] data = new int[packed.length];
      for (int i = 0; i < data.length; i++) {
        data[i] = packed[i];
      }
      chunk(out, "IDAT", data);
      chunk(out, "IEND");
    }
    return bytes.toByteArray();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 4, 8})
  void theTransparentGreyIsTheOneThatIsStored(final int depth) throws IOException {
    final int greys = 1 << depth;
    for (int transparent = 0; transparent < greys; transparent += Math.max(1, greys / 16)) {
      final Texture texture = TextureFile.read(Files.write(folder.resolve("a.png"), greys(depth, transparent)));
      for (int i = 0; i < greys; i++) {
        final int grey = i * 255 / (greys - 1);
        assertEquals(new Color(grey, grey, grey, i == transparent ? 0 : 255), texture.getColor((i + 0.5) / greys, 0.5));
      }
    }
  }
}
