package documentation;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.transform.TransformerFactory;
import javax.xml.transform.dom.DOMSource;
import javax.xml.transform.stream.StreamResult;

import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.InputSource;

/**
 * The page {@code doc/language.md}. Snippets that begin with an XML declaration are whole scenes; each of the others changes
 * the last whole scene before it, by putting its elements in the place of those that they are about.
 */
final class SceneLanguagePage {

  static final Path PAGE = Path.of("doc", "language.md");

  private static final Pattern SNIPPET = Pattern.compile(
      "^!\\[[^\\]]+\\]\\(language/([a-z-]+)\\.png\\)\\n\\n```xml\\n(.*?)^```$", Pattern.MULTILINE | Pattern.DOTALL);
  private static final Set<String> SECTIONS =
      Set.of("raster", "rayTracer", "engine", "camera", "projection", "lights", "materials", "models", "scene");
  private static final Map<String, String> SECTION_OF = Map.of("light", "lights", "brdf", "materials", "btdf", "materials",
      "model", "models", "object", "scene");

  private final String text;

  SceneLanguagePage() throws IOException {
    text = Files.readString(PAGE);
  }

  String text() {
    return text;
  }

  /** The scene files that the snippets make, in order, by the names of their pictures. */
  Map<String, String> scenes() throws Exception {
    final Map<String, String> scenes = new LinkedHashMap<>();
    String whole = null;
    final Matcher snippet = SNIPPET.matcher(text);
    while (snippet.find()) {
      final boolean isWhole = snippet.group(2).startsWith("<?xml");
      whole = isWhole ? snippet.group(2) : whole;
      if (scenes.put(snippet.group(1), isWhole ? whole : merged(whole, snippet.group(2))) != null) {
        throw new AssertionError("two pictures " + snippet.group(1));
      }
    }
    return scenes;
  }

  private static Document parsed(final String xml) throws Exception {
    return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new InputSource(new StringReader(xml)));
  }

  private static String merged(final String whole, final String snippet) throws Exception {
    final Document scene = parsed(whole);
    final Node parts = parsed("<snippet>" + snippet + "</snippet>").getDocumentElement();
    for (Node part = parts.getFirstChild(); part != null; part = part.getNextSibling()) {
      if (part instanceof Element element) {
        put(scene, (Element) scene.importNode(element, true));
      }
    }
    final StringWriter merged = new StringWriter();
    TransformerFactory.newInstance().newTransformer().transform(new DOMSource(scene), new StreamResult(merged));
    return merged.toString();
  }

  private static void put(final Document scene, final Element element) {
    final String name = element.getTagName();
    final Element image = scene.getDocumentElement();
    final Element section = SECTIONS.contains(name) ? image : first(image, SECTION_OF.get(name));
    for (Node node = section.getFirstChild(); node != null; node = node.getNextSibling()) {
      if (node instanceof Element present && key(present).equals(key(element))) {
        section.replaceChild(element, present);
        return;
      }
    }
    throw new AssertionError("the whole scene has no " + key(element));
  }

  /** What an element is about: its id, the model of an object, or else its name. */
  private static String key(final Element element) {
    if (element.hasAttribute("id")) {
      return element.getAttribute("id");
    }
    return element.getTagName().equals("object") ? first(element, "modelId").getTextContent() : element.getTagName();
  }

  private static Element first(final Element parent, final String name) {
    return (Element) parent.getElementsByTagName(name).item(0);
  }
}
