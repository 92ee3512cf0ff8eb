/**
 * Rays, what they hit, and where they come from.
 *
 * <p>A {@link tracer.Ray} is a start and a unit direction; a {@link tracer.Hit} is where a ray hits an object; a
 * {@link tracer.RayGenerator} makes the rays of a camera, one for each pixel. Two constants stand for absence, so that
 * nothing is null: {@link tracer.Ray#NORAY} and {@link tracer.Hit#NOHIT}. The conventions are in {@link primitives}.
 */
package tracer;
