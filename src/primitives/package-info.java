/**
 * Points, vectors and boxes. They depend on {@code javax.vecmath} and on the checks of {@link arguments}.
 *
 * <h2>Conventions of the whole project</h2>
 * <ul>
 * <li>Right-handed coordinates. In the camera's frame the eye is the origin and looks along −z, +x is to the
 *     right, +y up.</li>
 * <li>Lengths are in scene units. Angles in public constructors are in degrees.</li>
 * <li>Pixel (m, n) is column m from the left and row n from the bottom, both from 0; its ray passes through the
 *     pixel's centre (m + ½, n + ½).</li>
 * <li>The direction of a ray is of unit length, so its parameter t is the distance from its start. A hit is the
 *     smallest t &gt; 0; a ray that starts inside a closed object hits its far wall. A ray that starts exactly on
 *     a surface may or may not hit it there.</li>
 * <li>A normal is of unit length and belongs to the surface: outward, never turned towards the ray.</li>
 * <li>The public interface uses floats, as the assignment says; what is prone to cancellation is computed in double.</li>
 * <li>The points and vectors of vecmath are mutable, so objects copy those that they are given and return copies.</li>
 * <li>Wrong arguments cause an {@link java.lang.IllegalArgumentException}, thrown by {@link arguments.Arguments}.</li>
 * </ul>
 */
package primitives;
