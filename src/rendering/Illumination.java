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
 * The illumination of a scene: at each hit the light of its lights, unless an object blocks it, and the light of ideal
 * reflection and refraction. Source: Whitted, "An improved illumination model for shaded display", Communications of the
 * ACM 23(6), 1980.
 *
 * <p><img src="doc-files/Illumination.png" width="320" height="320" alt="A glass ball and a mirror ball in a room">
 *
 * <p>The radiance L of a hit is the sum over the lights of f(wi, wo) |n·wi| E, with E the irradiance of the light, if no
 * object lies on the open segment between; plus, for a material with an ideal part, its factors times the radiance along
 * the reflected and the refracted ray. The ray of a pixel has depth 0, and a ray made at a hit of a ray of depth k has
 * depth k + 1; rays deeper than the recursion depth contribute nothing. Rays that leave the scene contribute the radiance
 * that is shown as the background. A pixel is 10 · 2<sup>exposure</sup> · L, clamped to 1 and encoded by IEC 61966-2-1
 * (sRGB); so at exposure 0 a white matte surface is white at an irradiance of π/10.
 *
 * <p>An object without a material is matte, in its colour at the hit. Every object blocks light, transparent ones too.
 * Immutable, except for working space of each thread; the lights are those of the group at construction.
 */
public final class Illumination implements Shading {

  /** The reciprocal of the radiance that is shown as 1 at exposure 0. */
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
   * @param background colour shown by rays that leave the scene
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
   * The same illumination at another exposure. The background is not affected.
   *
   * @param exposure in stops, −20 … 20: each doubles the brightness
   * @return the new illumination
   * @throws IllegalArgumentException if the exposure is out of this range or NaN
   */
  public Illumination withExposure(final double exposure) {
    return new Illumination(scene, lights, recursionDepth, background, exposure);
  }

  /**
   * The contribution of one light: the illumination is the sum of those of all lights, and of the background that rays
   * that leave the scene show.
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

  /** A tracer for the calling thread. */
  WhittedTracer tracer() {
    return new WhittedTracer(this);
  }

  /**
   * The radiance along a ray, with a report of its contributions.
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
   * @return in stops; 0 by default
   */
  public double exposure() {
    return stops;
  }
}
