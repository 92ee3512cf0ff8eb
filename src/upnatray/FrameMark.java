package upnatray;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Collection;
import java.util.HexFormat;
import java.util.TreeSet;

import upnatray.PngChunks.Chunk;

/**
 * The mark of a picture of an animation, in a text of the PNG file: a digest (SHA-256) of all that the picture depends on.
 * It identifies pictures that need not be rendered again.
 */
final class FrameMark {

  private final byte[] common;

  /**
   * The marks of the pictures of an animation.
   *
   * @param files the files that the pictures are made of: the scene, meshes, materials, textures
   * @param settings what else they depend on, as a text
   * @throws IOException if a file cannot be read
   */
  FrameMark(final Collection<Path> files, final String settings) throws IOException {
    final MessageDigest digest = sha256();
    for (final Path file : new TreeSet<>(files)) {
      try (InputStream in = new DigestInputStream(Files.newInputStream(file), digest)) {
        digest.update((file.getFileName() + "\n" + Files.size(file) + "\n").getBytes(StandardCharsets.UTF_8));
        in.transferTo(OutputStream.nullOutputStream());
      }
    }
    digest.update(settings.getBytes(StandardCharsets.UTF_8));
    common = digest.digest();
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (final NoSuchAlgorithmException everyJavaHasIt) {
      throw new IllegalStateException(everyJavaHasIt);
    }
  }

  /** The mark of picture k. */
  String of(final int k) {
    final MessageDigest digest = sha256();
    digest.update(common);
    digest.update(Integer.toString(k).getBytes(StandardCharsets.UTF_8));
    return HexFormat.of().formatHex(digest.digest());
  }

  /** Whether a file is picture k, and complete. */
  boolean isOn(final Path file, final int k) {
    try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
      final PngChunks chunks = new PngChunks(in);
      final String mark = of(k);
      boolean marked = false;
      for (Chunk chunk = chunks.next(); chunk != null; chunk = chunks.next()) {
        marked |= mark.equals(chunk.text());
      }
      return marked;
    } catch (final IOException missingOrDamaged) {
      return false;
    }
  }

  /** Whether a file exists, is not empty, and is not a picture of an animation, of whatever scene. */
  static boolean isForeign(final Path file) {
    if (!Files.exists(file)) {
      return false;
    }
    try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
      if (Files.size(file) == 0) {
        return false;
      }
      final PngChunks chunks = new PngChunks(in);
      for (Chunk chunk = chunks.next(); chunk != null; chunk = chunks.next()) {
        if (chunk.text() != null) {
          return false;
        }
      }
      return true;
    } catch (final IOException damaged) {
      return true;
    }
  }
}
