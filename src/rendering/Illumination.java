package rendering;

import static arguments.Arguments.index;
import static arguments.Arguments.notNull;
import static arguments.Arguments.within;
import static arguments.Arguments.wrong;

import java.awt.Color;
import java.util.List;

import lights.Light;
import lights.LightGroup;
import models.Group3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;
import tracer.Hit;
import tracer.Ray;

/**
 * The light of a scene: what its lights bring to each hit, unless an object blocks them, and what ideal reflection and
 * refraction show there. Source: Whitted, "An improved illumination model for shaded display", Communications of the ACM
 * 23(6), 1980.
 *
 * <p><img src="doc-files/Illumination.png" width="320" height="320" alt="A glass ball and a mirror ball in a room">
 *
 * <p>The radiance L of a hit is the sum over the lights of f(wi, wo) |n·wi| E, with E the irradiance of the light, if no
 * object lies on the open segment between; plus, for a material with an ideal part, its factors times the radiance that the
 * reflected and the refracted ray bring. The ray of a pixel has depth 0, and a ray made at a hit of a ray of depth k has
 * depth k + 1; rays deeper than the recursion depth bring nothing. Those that leave the scene bring the radiance that is
 * shown as the background. A pixel is 10 · 2<sup>exposure</sup> · L, cut to 1 and encoded by IEC 61966-2-1 (sRGB); so at
 * exposure 0 a white matte surface is white at an irradiance of π/10.
 *
 * <p>An object without a material is matte, of its colour at the hit. Every object blocks light, transparent ones too.
 * Immutable, but for working space that each thread has of its own; the lights are those that the group holds when this is
 * made.
 */
public final class Illumination implements Shading {

  /** What is shown as 1 at exposure 0, as its reciprocal. */
  private static final double WHITE = 10;

  private static final double MOST_STOPS = 20;

  private final Group3D scene;
  private final List<Light> lights;
  private final int recursionDepth;
  private final Color background;
  private final double stops;
  private final double gain;
  private final ThreadLocal<WhittedTracer> tracers = ThreadLocal.withInitial(() -> new WhittedTracer(this));

  /**
   * The light of a scene.
   *
   * @param scene the objects, which reflect light and block it
   * @param lights the lights
   * @param recursionDepth greatest depth of a ray, at least 0; 0 is direct light only
   * @param background colour that rays which leave the scene show
   * @throws IllegalArgumentException if an argument is null, or the depth negative
   */
  public Illumination(final Group3D scene, final LightGroup lights, final int recursionDepth, final Color background) {
    this(notNull("scene", scene), notNull("lights", lights).getLights(), recursionDepth,
        notNull("background", background), 0);
  }

  private Illumination(final Group3D scene, final List<Light> lights, final int recursionDepth, final Color background,
      final double stops) {
    if (recursionDepth < 0) {
      throw wrong("negative", "recursionDepth", recursionDepth);
    }
    this.scene = scene;
    this.lights = lights;
    this.recursionDepth = recursionDepth;
    this.background = background;
    this.stops = within("stops", -MOST_STOPS, MOST_STOPS, stops);
    this.gain = WHITE * Math.pow(2, stops);
  }

  /**
   * The same light, seen brighter or darker. The background stays as it is.
   *
   * @param exposure in stops, −20 … 20: each doubles the brightness
   * @return the new illumination
   * @throws IllegalArgumentException if the exposure is out of this range or NaN
   */
  public Illumination withExposure(final double exposure) {
    return new Illumination(scene, lights, recursionDepth, background, exposure);
  }

  /**
   * What one of the lights brings: the light of the scene is the sum of those of all its lights, and of what rays that leave
   * the scene show of the background.
   *
   * @param number number of the light, from 0
   * @return the illumination by this light alone, before a black background
   * @throws IllegalArgumentException if there is no such light
   */
  public Illumination ofLight(final int number) {
    return new Illumination(scene, List.of(lights.get(index("number", lights.size(), number))), recursionDepth, Color.BLACK,
        stops);
  }

  @Override
  public int argb(final Ray ray, final Hit hit) {
    final WhittedTracer tracer = tracers.get();
    tracer.trace(ray, hit, LightObserver.NONE);
    return encoded(tracer.r(), tracer.g(), tracer.b());
  }

  /** The pixel of a radiance. */
  int encoded(final double r, final double g, final double b) {
    return SrgbEncoding.argb(gain * r, gain * g, gain * b);
  }

  /** A tracer for the calling thread alone. */
  WhittedTracer tracer() {
    return new WhittedTracer(this);
  }

  /**
   * The radiance that comes along a ray, and how it comes about.
   *
   * @param ray the ray, of depth 0
   * @param hit its closest hit in the scene
   * @param observer watches each surface, each light, and each ray that leaves the scene
   * @return the radiance; that of the background for {@link Hit#NOHIT}
   * @throws IllegalArgumentException if an argument is null
   */
  public RadianceRGB radiance(final Ray ray, final Hit hit, final LightObserver observer) {
    final WhittedTracer tracer = tracers.get();
    tracer.trace(notNull("ray", ray), notNull("hit", hit), notNull("observer", observer));
    return new RadianceRGB(tracer.r(), tracer.g(), tracer.b());
  }

  /**
   * The pixel that a radiance is shown as.
   *
   * @param radiance the radiance
   * @return sRGB, opaque
   * @throws IllegalArgumentException if the radiance is null
   */
  public int argb(final RadianceRGB radiance) {
    notNull("radiance", radiance);
    return encoded(radiance.getR(), radiance.getG(), radiance.getB());
  }

  /**
   * The radiance that is shown as the background.
   *
   * @return the colour of the background, decoded, without alpha
   */
  RadianceRGB backgroundRadiance() {
    final ReflectanceRGB linear = new ReflectanceRGB(background);
    return new RadianceRGB(linear.getR() / gain, linear.getG() / gain, linear.getB() / gain);
  }

  /**
   * The objects.
   *
   * @return the scene
   */
  public Group3D scene() {
    return scene;
  }

  /**
   * The lights.
   *
   * @return a list that does not change
   */
  public List<Light> lights() {
    return lights;
  }

  /**
   * Greatest depth of a ray.
   *
   * @return at least 0
   */
  public int recursionDepth() {
    return recursionDepth;
  }

  /**
   * The exposure.
   *
   * @return in stops; 0 unless it was chosen
   */
  public double exposure() {
    return stops;
  }
}
