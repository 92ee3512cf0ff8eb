/**
 * The program: images, how they are computed from a scene, and the command line.
 *
 * <p>{@link upnatray.Image#synthesis} is the assignment's loop over the pixels, in tiles and on all cores;
 * {@link upnatray.Rendering} says how (threads, {@link upnatray.Shading}, {@link upnatray.Progress}).
 */
package upnatray;
