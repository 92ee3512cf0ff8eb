/**
 * What surfaces do to light. Quantities and channels are those of {@link radiometry}.
 *
 * <p><a href="Lambertian.html"><img src="doc-files/Lambertian.png" width="160" height="120" alt="Lambertian"></a>
 * <a href="OrenNayar.html"><img src="doc-files/OrenNayar.png" width="160" height="120" alt="OrenNayar"></a>
 * <a href="PhongLafortune.html"><img src="doc-files/PhongLafortune.png" width="160" height="120" alt="PhongLafortune"></a>
 * <a href="ReflectiveCookTorrance.html"><img
 *     src="doc-files/ReflectiveCookTorrance.png" width="160" height="120" alt="ReflectiveCookTorrance"></a>
 * <a href="AshikhminShirley.html"><img
 *     src="doc-files/AshikhminShirley.png" width="160" height="120" alt="AshikhminShirley"></a>
 * <a href="IdealConductor.html"><img src="doc-files/IdealConductor.png" width="160" height="120" alt="IdealConductor"></a>
 * <a href="IdealDielectric.html"><img
 *     src="doc-files/IdealDielectric.png" width="160" height="120" alt="IdealDielectric"></a>
 * <a href="TransmissiveCookTorrance.html"><img
 *     src="doc-files/TransmissiveCookTorrance.png" width="160" height="120" alt="TransmissiveCookTorrance"></a>
 * <a href="Blinn.html"><img src="doc-files/Blinn.png" width="160" height="120" alt="Blinn"></a>
 * <a href="Horn.html"><img src="doc-files/Horn.png" width="160" height="120" alt="Horn"></a>
 * <a href="Torrance.html"><img src="doc-files/Torrance.png" width="160" height="120" alt="Torrance"></a>
 * <a href="GGX.html"><img src="doc-files/GGX.png" width="160" height="120" alt="GGX"></a>
 * <a href="Beckmann.html"><img src="doc-files/Beckmann.png" width="160" height="120" alt="Beckmann"></a>
 *
 * <h2>Conventions</h2>
 * <ul>
 * <li>Directions are unit vectors that point away from the surface: wi towards the light, wo towards the viewer. The
 *     normal n is on the viewer's side, n·wo &gt; 0; ci = n·wi, co = n·wo, h = unit(wi + wo), c = wo·h.</li>
 * <li>A BRDF or BTDF f is in 1/sr: the radiance towards wo is f times the irradiance on the surface, which includes ci.</li>
 * <li>A <em>lobe</em> shows lights; an <em>ideal</em> part shows none, as no ray hits a point, but the mirrored or
 *     refracted scene, which a renderer follows by recursion.</li>
 * <li>A {@link materials.BRDF} reflects on the viewer's side only; a {@link materials.BTDF} also shows lights on the
 *     other side. Both sides of a surface look alike, except for the indices of refraction: inside is the side opposite
 *     to the surface's own normal.</li>
 * <li>Reflectances are linear factors from 0 to 1. Angles are in degrees: β, the angle of half value of a
 *     {@link materials.NormalDistributionFunction}, and σ, the roughness of {@link materials.OrenNayar}.</li>
 * <li>Materials are immutable and are called by several threads concurrently.</li>
 * </ul>
 *
 * <h2>How to add a material</h2>
 * <p>Extend {@link materials.BRDF} and implement {@code reflect}. A surface that also mirrors overrides {@code mirror}.
 * As an example, a drawing with three steps of brightness:
 *
 * <pre>{@code
 * public class Toon extends BRDF {
 *   private final ReflectanceRGB k;
 *
 *   public Toon(ReflectanceRGB k) {
 *     this.k = k;
 *   }
 *
 *   @Override
 *   public RadianceRGB reflect(RadianceRGB E, Vector3D wi, Vector3D wo, Vector3D n) {
 *     double c = n.dot(wi);
 *     return E.times(k).times(Math.ceil(3 * c) / (3 * c) / Math.PI);
 *   }
 * }
 * }</pre>
 *
 * <p>A distribution of microfacets extends {@link materials.NormalDistributionFunction} and implements {@code density}.
 * The tests have an interface of laws for BRDFs, {@code BRDFContract}; a test of a new one implements it.
 *
 * <h2>For renderers</h2>
 * <p>A renderer keeps a {@link materials.SurfaceInteraction} and some {@link materials.SpecularRays} for each thread;
 * with the materials of this package nothing is allocated. At a hit, {@code setView}; for each light that is on the right
 * side, before any search for obstacles, {@code setIncident}, {@code setIrradiance} and
 * {@link materials.Material#scatter}; then {@link materials.Material#specular}. A light counts if it is in front of the
 * surface by both normals, or behind it by both if the material {@link materials.Material#transmits}.
 */
package materials;
