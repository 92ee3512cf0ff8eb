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
 * <li>The public interface is in floats, as assigned; what can cancel is computed in double.</li>
 * <li>Points and vectors are mutable in vecmath, so objects copy what they are given and hand out copies.</li>
 * <li>Wrong arguments are answered with {@link java.lang.IllegalArgumentException}, by {@link arguments.Arguments}.</li>
 * </ul>
 */
package primitives;
