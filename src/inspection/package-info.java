/**
 * Explains why a pixel looks as it does, as plain data: nothing here paints, and no rendering uses it.
 *
 * <p>{@link inspection.Inspector} reports the ray of a pixel and how the projection computes it, all objects that the ray
 * hits, and how the colour is computed; {@link inspection.JUnitTestWriter} turns such a hit into a JUnit test;
 * {@link inspection.Difference} compares two pictures; {@link inspection.Wireframe} is a line drawing of camera and scene.
 */
package inspection;
