/**
 * Scene files: the XML language in which a whole picture is described.
 *
 * <p>{@link scenes.SceneReader} reads a file into a {@link scenes.SceneFile} and reports every {@link diagnostics.Problem}
 * with line and column. Text becomes elements ({@code MarkupReader}), whose names are checked against those of the language
 * ({@code SceneGrammar}) and whose values are read by kind ({@code Values}); each section has a reader of its own. A new
 * model needs a row in {@code SceneGrammar}, a record in {@code Shapes}, a line in {@code ModelReader} and one in
 * {@code scenes/scene.xsd}. The library does not know this package.
 */
package scenes;
