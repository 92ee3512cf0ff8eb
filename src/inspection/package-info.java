/**
 * Answers to "why does this pixel look like that?", as plain data: nothing here draws, and nothing of it is on the way of a
 * normal rendering.
 *
 * <p>{@link inspection.Inspector} tells of a pixel its ray and how the projection made it, all objects that the ray meets,
 * and how the colour comes about; {@link inspection.JUnitTestWriter} writes such a hit down as a JUnit test;
 * {@link inspection.Difference} compares two pictures; {@link inspection.Wireframe} is a line drawing of camera and scene
 * seen from outside.
 */
package inspection;
