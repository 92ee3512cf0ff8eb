package scenes;

import java.awt.image.BufferedImage;
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

import javax.imageio.ImageIO;

/** Damaged files: valid ones, changed at a few random places. */
final class Mutations {

  /** A way of changing a file. */
  enum Kind {
    SCENE_BYTES, SCENE_WORDS, SCENE_STRUCTURE, OBJ_BYTES, OBJ_WORDS, OBJ_STRUCTURE, ZIP_BYTES,
    MTL_BYTES, MTL_WORDS, MTL_STRUCTURE, PNG_BYTES, JPEG_BYTES, GIF_BYTES, BMP_BYTES;

    boolean isScene() {
      return ordinal() < OBJ_BYTES.ordinal();
    }

    boolean isMaterial() {
      return name().startsWith("MTL");
    }

    boolean isImage() {
      return ordinal() >= PNG_BYTES.ordinal();
    }
  }

  /** Name of the mesh that the scenes refer to, in their own folder. */
  static final String MESH_FILE = "mesh.obj";

  static final String MESH = "# a square and more\nv 0 0 0\nv 1 0 0 1 1 1\nv 1 1 0\r\nv 0 1 1e-3\nvn 0 0 1\nvt 0 0\n"
      + "f 1 2 3 4\nf 1//1 2//1 3//1\nf -4/1 -3/1 \\\n -1/1\ng group\nf 2/1/1 3/1/1 4/1/1\nvn 0 1 1\n"
      + "vn nan 0 1\nvt 0.5\nvt 1 1 0\nmtllib fuzz.mtl\nusemtl red\n"
      + "f 1/1/2 2/2/2 3/3/1 4//3\nusemtl Material #2\nv 2 2 0\nf 1 2 5 3 4\n";

  /** Name of the material file that the mesh refers to, and of the image that a material refers to. */
  static final String MATERIAL_FILE = "fuzz.mtl";
  static final String IMAGE_FILE = "fuzz.png";

  private static final String MATERIALS = "# materials\nnewmtl red\nKd 1 0 0\nd 0.5\nnewmtl Material #2\nKa 1 1 1\nKd 0.5\n"
      + "Tr 0.25\nmap_Kd -o 0.5 0 -mm 0 1 -clamp on fuzz.png\nillum 2\nnewmtl red\nKd spectral a.rfl\n";

  private static final int LONGEST_SCENE = 20_000;

  private static final String[] WORDS = {"0", "-1", "1e30", "1e-30", "1e99", "NaN", "-0", "3.4028235e38", "2147483648",
    "-2147483648", "", " ", "0x1p3", "1,5", "255", "true", "<", ">", "&", "&amp;", "<!--", "-->", "<![CDATA[", "]]>",
    "<!DOCTYPE a>", "<?xml?>", "\"", "'", "\u0000", "\ufffe", "ñ", "🚀", "\\", "\\\n", "\r", "#", "/", "1/2/3", "-1//-1",
    "f", "v", "f 1 2 3\n", "v 0 0 0\n"};

  private final List<String> scenes = new ArrayList<>();

  Mutations() throws IOException {
    try (Stream<Path> files = Files.list(Path.of("scenes"))) {
      for (final Path file : files.filter(path -> path.toString().endsWith(".xml")).sorted().collect(Collectors.toList())) {
        final String text = Files.readString(file);
        if (text.length() < LONGEST_SCENE) {
          scenes.add(text.replaceAll("<objFile>.*?</objFile>", "<objFile>" + MESH_FILE + "</objFile>"));
        }
      }
    }
    scenes.add(SceneFiles.SOUND);
  }

  /** The file of a seed. */
  byte[] file(final Kind kind, final long seed) throws IOException {
    // Generators of neighbouring seeds begin alike, unless the seeds are spread.
    final Random random = new Random(seed * 0x9E3779B97F4A7C15L);
    final String text = kind.isScene() ? scenes.get(random.nextInt(scenes.size())) : kind.isMaterial() ? MATERIALS : MESH;
    return switch (kind) {
      case SCENE_BYTES, OBJ_BYTES, MTL_BYTES -> bytes(text.getBytes(StandardCharsets.UTF_8), random);
      case SCENE_WORDS, OBJ_WORDS, MTL_WORDS -> words(text, random).getBytes(StandardCharsets.UTF_8);
      case SCENE_STRUCTURE -> pieces(text, "(?=<)", random).getBytes(StandardCharsets.UTF_8);
      case OBJ_STRUCTURE, MTL_STRUCTURE -> pieces(text, "(?<=\n)|(?= )", random).getBytes(StandardCharsets.UTF_8);
      case ZIP_BYTES -> bytes(zip(text), random);
      case PNG_BYTES, JPEG_BYTES, GIF_BYTES, BMP_BYTES -> bytes(image(kind.name().split("_")[0], random), random);
    };
  }

  /** An image of a format; any of a few kinds of pixels, where the format has them. */
  static byte[] image(final String format, final Random random) throws IOException {
    final int[] types = {BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_BYTE_INDEXED,
        BufferedImage.TYPE_BYTE_BINARY, BufferedImage.TYPE_INT_ARGB, BufferedImage.TYPE_USHORT_GRAY};
    final boolean opaque = format.equals("JPEG") || format.equals("BMP");
    final BufferedImage image = new BufferedImage(9, 7, types[random.nextInt(opaque ? 2 : types.length)]);
    for (int i = 0; i < 63; i++) {
      image.setRGB(i % 9, i / 9, random.nextInt());
    }
    final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(image, format, bytes);
    return bytes.toByteArray();
  }

  private static byte[] zip(final String text) throws IOException {
    final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      zip.putNextEntry(new ZipEntry(MESH_FILE));
      zip.write(text.repeat(20).getBytes(StandardCharsets.UTF_8));
    }
    return bytes.toByteArray();
  }

  private static byte[] bytes(final byte[] original, final Random random) {
    byte[] bytes = original.clone();
    for (int i = 1 + random.nextInt(8); i > 0; i--) {
      final int at = random.nextInt(bytes.length);
      if (random.nextInt(20) == 0) {
        bytes = Arrays.copyOf(bytes, Math.max(1, at));
      } else {
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
