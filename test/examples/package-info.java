/**
 * The programs that wrote the larger files of the folder {@code scenes}: meshes, and scenes of hundreds of objects;
 * and {@link examples.ShapePictures}, {@link examples.LitPictures} and {@link examples.ScenePictures}, which draw for the
 * documentation.
 *
 * <p>{@link examples.ExamplesTest} compares each file with the output of its program. To change a file, change its
 * program, and let the test write it:
 *
 * <p>{@code ant test-single -Dtest.includes=examples/ExamplesTest.java -Dtest.jvmargs="-ea -Dexamples.write=true"}.
 */
package examples;
