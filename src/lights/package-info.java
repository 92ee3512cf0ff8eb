/**
 * Sources of light. Their quantities, units and channels are those of {@link radiometry}, their frames and lengths those of
 * {@link primitives}.
 *
 * <p><a href="Omnidirectional.html"><img
 *     src="doc-files/Omnidirectional.png" width="160" height="120" alt="Omnidirectional"></a>
 * <a href="Spot.html"><img src="doc-files/Spot.png" width="160" height="120" alt="Spot"></a>
 * <a href="Directional.html"><img src="doc-files/Directional.png" width="160" height="120" alt="Directional"></a>
 *
 * <ul>
 * <li>The irradiance of a light is measured <em>perpendicular</em> to the direction from which the light comes: a surface
 *     with the normal n receives n·wi times as much, wi being the direction towards the light.</li>
 * <li>Directions point away from the lit point, as everywhere in {@link materials}: wi leads from P to the light.</li>
 * <li>A light knows no obstacles. A renderer looks for them on the open segment from P to the point from which P is lit;
 *     what lies behind that point does not block.</li>
 * <li>Lights cannot be seen and cast no shadow. The edges of their fields are sharp, and the edge itself is lit.</li>
 * <li>Lights are immutable and are called by several threads concurrently.</li>
 * </ul>
 *
 * <h2>How to add a light</h2>
 * <p>Extend {@link lights.Light} and implement {@code getIrradianceAt}. A light of more than one point also overrides
 * {@code getPosition(P)}, the point from which P is lit. As an example, a flame that is not blinding from near by:
 *
 * <pre>{@code
 * public class Candle extends Light {
 *   public Candle(Point3D S, SpectrumRGB spectrum, float power) {
 *     super(S, spectrum, power);
 *   }
 *
 *   @Override
 *   public RadianceRGB getIrradianceAt(Point3D P) {
 *     float d = P.distance(getPosition());
 *     return getPower().times(1 / (4 * Math.PI * (1 + d * d * d)));
 *   }
 * }
 * }</pre>
 *
 * <p>The tests have an interface of laws for lights, {@code LightContract}; a test of a new light implements it.
 *
 * <h2>For renderers</h2>
 * <p>{@link lights.Light#illuminate} gives irradiance, direction and distance at once, in double, into an
 * {@link lights.Incidence} that the caller keeps: the lights of this package allocate nothing in it.
 */
package lights;
