package scenes;

import static arguments.Arguments.notNull;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import javax.vecmath.Tuple3f;

import arguments.Messages;
import diagnostics.UnicodeMark;
import view.Camera;

/**
 * The numbers of a camera as a scene file has them. Writing them changes these nine numbers in the file and nothing else:
 * comments, blanks, line ends and encoding are preserved.
 *
 * @param position the three numbers of {@code position}
 * @param lookAt the three numbers of {@code lookAt}
 * @param up the three numbers of {@code up}
 */
public record CameraText(List<String> position, List<String> lookAt, List<String> up) {

  private static final List<String> NAMES = List.of("position", "lookAt", "up");

  /**
   * Copies the lists.
   *
   * @param position the three numbers of {@code position}
   * @param lookAt the three numbers of {@code lookAt}
   * @param up the three numbers of {@code up}
   */
  public CameraText {
    position = List.copyOf(position);
    lookAt = List.copyOf(lookAt);
    up = List.copyOf(up);
  }

  /**
   * The numbers of a camera.
   *
   * @param camera the camera
   * @return its numbers, with as many digits as distinguish floats
   * @throws IllegalArgumentException if the camera is null
   */
  public static CameraText of(final Camera camera) {
    return new CameraText(numbers(notNull("camera", camera).getPosition()), numbers(camera.getLookAt()),
        numbers(camera.getUp()));
  }

  private static List<String> numbers(final Tuple3f tuple) {
    return List.of(number(tuple.x), number(tuple.y), number(tuple.z));
  }

  private static String number(final float number) {
    return number == 0 ? "0" : new BigDecimal(Float.toString(number)).stripTrailingZeros().toPlainString();
  }

  /**
   * Returns the element {@code camera} of a scene file.
   *
   * @return one line, without a line end
   */
  public String toXml() {
    final StringBuilder xml = new StringBuilder("<camera>");
    for (int i = 0; i < NAMES.size(); i++) {
      xml.append('<').append(NAMES.get(i)).append('>').append(String.join(" ", all().get(i))).append("</")
          .append(NAMES.get(i)).append('>');
    }
    return xml.append("</camera>").toString();
  }

  private List<List<String>> all() {
    return List.of(position, lookAt, up);
  }

  /**
   * Writes the numbers into a scene file. A number that already has the value of the new one keeps its spelling. The file is
   * replaced as a whole or not at all; a symbolic link stays a link.
   *
   * @param file a scene file without errors in its camera
   * @return the numbers that were replaced; writing them to the file restores it
   * @throws IOException if the file cannot be read or written, or has no camera whose numbers can be replaced
   * @throws IllegalArgumentException if the file is null
   */
  public CameraText writeTo(final Path file) throws IOException {
    final Path place = notNull("file", file).toRealPath();
    final byte[] bytes = Files.readAllBytes(place);
    final Decoding decoding = Decoding.of(bytes);
    final StringBuilder text = new StringBuilder(decoding.text());
    final Charset charset = charset(bytes, decoding);
    final int mark = bytes.length - decoding.text().getBytes(charset).length;
    final List<List<NumberToken>> found = find(file, decoding.text());
    final CameraText before = new CameraText(texts(found.get(0)), texts(found.get(1)), texts(found.get(2)));
    final List<NumberToken> tokens = new ArrayList<>();
    final List<String> numbers = new ArrayList<>();
    for (int i = 0; i < NAMES.size(); i++) {
      tokens.addAll(found.get(i));
      numbers.addAll(all().get(i));
    }
    replace(text, tokens, numbers);
    final byte[] body = text.toString().getBytes(charset);
    final byte[] result = Arrays.copyOf(bytes, mark + body.length);
    System.arraycopy(body, 0, result, mark, body.length);
    new WholeFile(place).write(result);
    return before;
  }

  /** The encoding that reproduces the bytes of the file, after a possible byte-order mark. */
  private static Charset charset(final byte[] bytes, final Decoding decoding) throws IOException {
    final List<Charset> candidates = new ArrayList<>(List.of(StandardCharsets.UTF_8, StandardCharsets.ISO_8859_1,
        StandardCharsets.UTF_16BE, StandardCharsets.UTF_16LE));
    if (UnicodeMark.of(bytes).charset() != null) {
      candidates.add(0, UnicodeMark.of(bytes).charset());
    }
    if (decoding.encoding() != null && Charset.isSupported(decoding.encoding())) {
      candidates.add(0, Charset.forName(decoding.encoding()));
    }
    for (final Charset charset : candidates) {
      final byte[] body = charset.canEncode() ? decoding.text().getBytes(charset) : new byte[0];
      final int mark = bytes.length - body.length;
      if (mark >= 0 && mark <= UnicodeMark.LONGEST && Arrays.equals(body, 0, body.length, bytes, mark, bytes.length)) {
        return charset;
      }
    }
    throw new IOException(Messages.text("scenes.cameraEncoding"));
  }

  private static List<List<NumberToken>> find(final Path file, final String text) throws IOException {
    final Element image;
    try {
      final Element root = new MarkupReader(new Problems(new SourceText(file.toString(), text))).read();
      image = root.name().equals("image") ? root : root.find("image");
    } catch (final XmlSyntaxException fault) {
      throw new IOException(fault.getMessage(), fault);
    }
    final Element camera = image == null ? null : image.find("camera");
    final List<List<NumberToken>> found = new ArrayList<>();
    for (final String name : NAMES) {
      final Element value = camera == null ? null : camera.find(name);
      final List<NumberToken> tokens = value == null ? List.of() : NumberToken.within(value, text);
      if (tokens.size() < 3) {
        throw new IOException(Messages.text("scenes.cameraIncomplete", name));
      }
      found.add(tokens.subList(0, 3));
    }
    return found;
  }

  private static List<String> texts(final List<NumberToken> tokens) {
    return tokens.stream().map(NumberToken::text).toList();
  }

  /** Replaces tokens by numbers, the last one in the file first, so that the places of the others stay valid. */
  private static void replace(final StringBuilder text, final List<NumberToken> tokens, final List<String> numbers) {
    final List<Integer> order = new ArrayList<>();
    for (int i = 0; i < tokens.size(); i++) {
      order.add(i);
    }
    order.sort((a, b) -> Integer.compare(tokens.get(b).start(), tokens.get(a).start()));
    for (final int i : order) {
      final NumberToken token = tokens.get(i);
      if (!token.hasValueOf(numbers.get(i))) {
        text.replace(token.start(), token.start() + token.text().length(), numbers.get(i));
      }
    }
  }
}
