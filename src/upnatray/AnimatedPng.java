package upnatray;

import java.awt.image.BufferedImage;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

import javax.imageio.ImageIO;

import upnatray.PngChunks.Chunk;

/**
 * An animated PNG file (APNG), whose pictures are those of PNG files of the same size, repeated endlessly. It is a PNG
 * file: programs that know no animations show its first picture; all current browsers show the animation. A GIF, which
 * ImageIO can write, has no more than 256 colours and no partial transparency; an APNG has the pictures' own pixels. Their
 * compressed data is copied as it is.
 *
 * <p>Source: W3C, "Portable Network Graphics (PNG) Specification", third edition, 2025, sections 4.9 and 11.3.6.
 */
final class AnimatedPng {

  private static final int[] NONE = {};
  private static final int FOREVER = 0;
  private static final int REPLACE = 0;
  private static final int GREATEST_SHORT = 65_535;

  /** Where the header has the number of bits and the kind of colours. */
  private static final int DEPTH = 8;
  private static final int COLOUR_TYPE = 9;
  private static final int RGB = 2;
  private static final int RGBA = 6;

  private final List<Path> pictures;
  private final OutputStream out;
  /** Numerator and denominator of the seconds for which a picture is shown. */
  private final int[] delay;
  private int sequence;

  private AnimatedPng(final List<Path> pictures, final double seconds, final OutputStream out) {
    this.pictures = pictures;
    this.out = out;
    this.delay = fraction(seconds / pictures.size());
  }

  /**
   * Writes an animation.
   *
   * @param pictures the PNG files of its pictures, at least one, all of the same size
   * @param seconds how long it takes to show them once
   * @param stream where to
   * @throws IOException if a picture cannot be read, or the animation cannot be written
   */
  static void write(final List<Path> pictures, final double seconds, final OutputStream stream) throws IOException {
    final BufferedOutputStream out = new BufferedOutputStream(stream);
    new AnimatedPng(pictures, seconds, out).write();
    out.flush();
  }

  private void write() throws IOException {
    final boolean alike = areAlike();
    out.write(PngChunks.SIGNATURE);
    for (int k = 0; k < pictures.size(); k++) {
      try (InputStream in = alike ? new BufferedInputStream(Files.newInputStream(pictures.get(k)))
          : new ByteArrayInputStream(withAlpha(pictures.get(k)))) {
        copy(k, new PngChunks(in));
      }
    }
    PngChunks.of("IEND", NONE, NONE).writeTo(out);
  }

  private void copy(final int k, final PngChunks picture) throws IOException {
    final Chunk header = picture.next();
    if (k == 0) {
      header.writeTo(out);
      PngChunks.of("acTL", new int[] {pictures.size(), FOREVER}, NONE).writeTo(out);
    }
    final ByteBuffer size = ByteBuffer.wrap(header.data());
    PngChunks.of("fcTL", new int[] {sequence++, size.getInt(), size.getInt(), 0, 0}, delay, REPLACE, REPLACE).writeTo(out);
    for (Chunk chunk = picture.next(); chunk != null; chunk = picture.next()) {
      if ("IDAT".equals(chunk.type())) {
        (k == 0 ? chunk : numbered(chunk)).writeTo(out);
      }
    }
  }

  /** Data of a picture other than the first: it is preceded by a number. */
  private Chunk numbered(final Chunk chunk) throws IOException {
    final ByteArrayOutputStream data = new ByteArrayOutputStream(Integer.BYTES + chunk.data().length);
    final DataOutputStream numbered = new DataOutputStream(data);
    numbered.writeInt(sequence++);
    numbered.write(chunk.data());
    return new Chunk("fdAT", data.toByteArray());
  }

  /** Whether all pictures have the same kind of pixels, so that one header fits them: an opaque picture has no alpha. */
  private boolean areAlike() throws IOException {
    final byte[] first = header(pictures.get(0));
    for (final Path picture : pictures) {
      if (!Arrays.equals(first, header(picture))) {
        return false;
      }
    }
    return first[DEPTH] == Byte.SIZE && (first[COLOUR_TYPE] == RGB || first[COLOUR_TYPE] == RGBA);
  }

  private static byte[] header(final Path picture) throws IOException {
    try (InputStream in = new BufferedInputStream(Files.newInputStream(picture))) {
      return new PngChunks(in).next().data();
    }
  }

  private static byte[] withAlpha(final Path picture) throws IOException {
    final BufferedImage image = PngEncoder.argb(ImageIO.read(picture.toFile()));
    final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(image, "png", bytes);
    return bytes.toByteArray();
  }

  /** A number as a fraction whose numerator and denominator fit in two bytes each, as accurate as possible. */
  private static int[] fraction(final double number) {
    int denominator = 10_000;
    while (number * denominator > GREATEST_SHORT) {
      denominator /= 10;
    }
    return new int[] {(int) Math.round(number * denominator), denominator};
  }
}
