package scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javax.xml.XMLConstants;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.xml.sax.SAXException;

/** The schema of scene files agrees with the reader, and our scenes are valid. */
class SchemaTest {

  private static final Path FOLDER = Path.of("scenes");

  private static Schema schema;

  @BeforeAll
  static void readSchema() throws SAXException {
    schema = SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI).newSchema(FOLDER.resolve("scene.xsd").toFile());
  }

  static Stream<Path> scenes() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      return files.filter(file -> file.toString().endsWith(".xml")).sorted().collect(Collectors.toList()).stream();
    }
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void eachOfOurScenesKeepsToTheSchemaAndIsReadWithoutAWord(final Path scene) throws Exception {
    schema.newValidator().validate(new StreamSource(scene.toFile()));
    assertTrue(Files.readString(scene).contains("xsi:noNamespaceSchemaLocation=\"scene.xsd\""), scene.toString());
    assertEquals("[]", SceneReader.read(scene).problems().toString());
  }

  private static void validate(final String text) throws SAXException, IOException {
    schema.newValidator().validate(new StreamSource(new StringReader(text)));
  }

  @Test
  void aSoundSceneIsValid() throws Exception {
    validate(SceneFiles.SOUND);
    validate(SceneFiles.with("</model>", "</model>\n-->"));
    validate(SceneFiles.with("<radius>1", "<radius> +1.50e0 "));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|',
      value = {"<W>40|<W>0", "<radius>1|<radius>0", "<radius>1|<radius>NaN", "<radius>1|<radius>1f", "<radius>|<Radius>",
    "type=\"sphere\"|type=\"spere\"", "<modelId>ball|<modelId>bull", "255 0 0|256 0 0", "<up>0 1 0|<up>0 "
        + "1", "\"perspective\"|\"nlperspective\"",
    "<showProgress>true|<showProgress>yes", "<fov>60|<fov>181"})
  void whatIsWrongIsNotValid(final String part, final String other) {
    assertThrows(SAXException.class, () -> validate(SceneFiles.SOUND.replace(part,
        other).replace("</Radius>", "</radius>")));
  }

  /** Each name of the language has a documented element in the schema, and the schema has no others. */
  @Test
  void schemaAndReaderKnowTheSameNames() throws IOException {
    final Set<String> known = new TreeSet<>(SceneGrammar.names());
    known.add("image");
    known.add("center");
    known.add("attenuationExponent");
    final Set<String> documented = new TreeSet<>();
    final String text = Files.readString(FOLDER.resolve("scene.xsd"));
    final Matcher element = Pattern.compile("<xs:element name=\"(\\w+)\"[^>]*>\\s*<xs:annotation>").matcher(text);
    while (element.find()) {
      documented.add(element.group(1));
    }
    assertEquals(known, documented);
  }

  @Test
  void schemaAndReaderKnowTheSameTypesOfModels() throws IOException {
    final SceneGrammar grammar = new SceneGrammar(new Problems(new SourceText("f", "")));
    final String text = Files.readString(FOLDER.resolve("scene.xsd"));
    for (final String element : new String[] {"model", "light"}) {
      final int from = text.indexOf("<xs:simpleType name=\"" + element + "Type\">");
      final Matcher value = Pattern.compile("<xs:enumeration value=\"([\\w-]+)\"").matcher(text.substring(from,
          text.indexOf("</xs:simpleType>", from)));
      final Set<String> types = new TreeSet<>();
      while (value.find()) {
        types.add(value.group(1));
      }
      assertEquals(new TreeSet<>(grammar.types(element)), types);
    }
  }
}
