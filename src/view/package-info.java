/**
 * Cameras and the projections through which they see.
 *
 * <p>A {@link view.Camera} stands at a point, looks at another, and holds a {@link view.Projection}, which creates the
 * {@link tracer.RayGenerator} of an image. In the camera's frame the eye is the origin, x is to the right, y up, and
 * the camera looks along −z. Angles are in degrees.
 *
 * <p>A new projection extends {@link view.Projection} and returns a {@link tracer.RayGenerator} of its own, which has to
 * implement {@code getRay} only. In this package {@code zAt} is enough: {@code CentralRayGenerator} makes rays of it.
 */
package view;
