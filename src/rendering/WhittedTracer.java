package rendering;

import lights.Incidence;
import lights.Light;
import materials.Material;
import materials.SpecularRays;
import materials.SurfaceInteraction;
import radiometry.RadianceRGB;
import tracer.Hit;
import tracer.Ray;

/**
 * Finds the radiance along a ray for {@link Illumination}: shades its hit, then follows the reflected and refracted rays
 * made there, and so on, until none is left. Those that wait are kept in a stack of its own, never more than their
 * greatest depth plus one, so that facing mirrors do not fill that of Java. One for each thread; nothing is allocated on
 * the way but rays and hits.
 */
final class WhittedTracer {

  /** A ray whose weight in the largest channel is below this makes no visible contribution. */
  private static final double LEAST_WEIGHT = 1e-6;

  /** Fraction of the way to a light within which an object blocks it: the object that the light is on does not. */
  static final double BEFORE_LIGHT = 1 - 1e-9;

  private final TracerCalls calls;
  private final Light[] lights;
  private final int recursionDepth;
  private final RadianceRGB background;
  private final Incidence incidence = new Incidence();
  private final SurfaceInteraction interaction = new SurfaceInteraction();
  private final SpecularRays specular = new SpecularRays();
  private final ViewedSurface surface = new ViewedSurface();

  private final RayStack waiting = new RayStack();

  /** Where surfaces and background are kept to be lit later, instead of at once; null if they are not. */
  private DeferredLight deferred;
  /** Reports to the observer; null without one, so that unobserved rays allocate nothing for it. */
  private TraceReport report;
  /** The ray at hand, its depth and its weight. */
  private Ray ray;
  private int depth;
  private double weightR;
  private double weightG;
  private double weightB;
  private double r;
  private double g;
  private double b;
  /** What the lights bring to the surface at hand. */
  private double sumR;
  private double sumG;
  private double sumB;
  private long lit;
  private long shadowed;

  WhittedTracer(final Illumination illumination) {
    this.calls = new TracerCalls(illumination.scene());
    this.lights = illumination.lights().toArray(new Light[0]);
    this.recursionDepth = illumination.recursionDepth();
    this.background = illumination.backgroundRadiance();
  }

  double r() {
    return r;
  }

  double g() {
    return g;
  }

  double b() {
    return b;
  }

  /** Which of the first 64 lights bring something to the first hit: bit i stands for light i. */
  long lit() {
    return lit;
  }

  /** Which of the first 64 lights would bring something to the first hit, but are blocked. */
  long shadowed() {
    return shadowed;
  }

  /** Finds the radiance of a ray of depth 0 from its closest hit. */
  void trace(final Ray first, final Hit hit, final LightObserver observer) {
    report = observer == LightObserver.NONE ? null : new TraceReport(observer, incidence, interaction, specular);
    deferred = null;
    begin(first);
    follow(hit);
    followWaiting();
  }

  /** Follows the reflected and refracted rays from the closest hit of a ray of depth 0, and keeps what they see. */
  void traceSpecular(final Ray first, final Hit hit, final Material material, final DeferredLight seen) {
    report = null;
    deferred = seen;
    begin(first);
    view(hit);
    makeRays(material);
    followWaiting();
  }

  private void begin(final Ray first) {
    r = 0;
    g = 0;
    b = 0;
    lit = 0;
    shadowed = 0;
    waiting.clear();
    take(first, 0, 1, 1, 1);
  }

  private void followWaiting() {
    while (!waiting.isEmpty()) {
      final Ray next = waiting.pop();
      take(next, waiting.depth(), waiting.weight(0), waiting.weight(1), waiting.weight(2));
      follow(calls.closestHit(ray));
    }
  }

  private void follow(final Hit hit) {
    if (hit.hits()) {
      shade(hit);
    } else if (deferred != null) {
      deferred.addBackground(weightR, weightG, weightB);
    } else {
      final double br = weightR * background.getR(), bg = weightG * background.getG(), bb = weightB * background.getB();
      if (report != null) {
        report.background(ray, depth, new RadianceRGB(br, bg, bb));
      }
      add(br, bg, bb);
    }
  }

  private void take(final Ray next, final int itsDepth, final double wr, final double wg, final double wb) {
    ray = next;
    depth = itsDepth;
    weightR = wr;
    weightG = wg;
    weightB = wb;
  }

  private void add(final double dr, final double dg, final double db) {
    r += dr;
    g += dg;
    b += db;
  }

  private void view(final Hit hit) {
    surface.set(ray, hit);
    interaction.setView(surface.normalX(), surface.normalY(), surface.normalZ(),
        -ray.directionX(), -ray.directionY(), -ray.directionZ(), surface.isSeenFromOutside());
  }

  /** Adds what the lights bring to a hit of the ray at hand, and makes the rays that leave it. */
  private void shade(final Hit hit) {
    final Material material = calls.material(ray, hit);
    view(hit);
    if (report != null) {
      report.surface(new LightObserver.Surface(ray, hit, depth, new RadianceRGB(weightR, weightG, weightB),
          material, surface.normal(), surface.isSeenFromOutside()));
    }
    if (deferred != null && material.scatters()) {
      deferred.add(ray, hit, surface, material, weightR, weightG, weightB);
    } else if (material.scatters() || report != null) {
      addLights(hit, material);
    }
    makeRays(material);
  }

  /** Adds the sum of what all lights bring, times the weight. */
  private void addLights(final Hit hit, final Material material) {
    sumR = 0;
    sumG = 0;
    sumB = 0;
    for (int i = 0; i < lights.length; i++) {
      if (calls.illuminate(lights[i], ray, hit, incidence)) {
        addLight(i, material);
      } else if (report != null) {
        report.dark(lights[i], i, LightObserver.Outcome.OUTSIDE_FIELD);
      }
    }
    add(weightR * sumR, weightG * sumG, weightB * sumB);
  }

  private void makeRays(final Material material) {
    if ((depth < recursionDepth || report != null) && calls.findSpecular(material, ray,
        interaction.cosineOut(), surface.isSeenFromOutside(), specular)) {
      push(specular.refractedR(), specular.refractedG(), specular.refractedB(), true);
      push(specular.reflectedR(), specular.reflectedG(), specular.reflectedB(), false);
    }
  }

  /** Adds what the surface sends along the ray of the light that falls in, unless it is zero or something blocks it. */
  private void addLight(final int number, final Material material) {
    final double wx = incidence.directionX(), wy = incidence.directionY(), wz = incidence.directionZ();
    interaction.setIncident(wx, wy, wz);
    final double ci = interaction.cosineIn(), facing = surface.facing(wx, wy, wz);
    final boolean before = ci > 0 && facing > 0, counts = before || ci < 0 && facing < 0 && material.transmits();
    if (!counts || !material.scatters()) {
      if (report != null) {
        report.dark(lights[number], number, counts ? LightObserver.Outcome.NOT_REFLECTED : LightObserver.Outcome.BEHIND);
      }
      return;
    }
    final double k = Math.abs(ci);
    interaction.setIrradiance(k * incidence.irradianceR(), k * incidence.irradianceG(), k * incidence.irradianceB());
    calls.scatter(material, ray, interaction);
    final double lr = interaction.radianceR(), lg = interaction.radianceG(), lb = interaction.radianceB();
    if (lr > 0 || lg > 0 || lb > 0) {
      final Ray shadowRay = surface.towards(before, wx, wy, wz, incidence.distance());
      final boolean blocked = calls.isBlocked(shadowRay, surface.distance() * BEFORE_LIGHT);
      if (report != null) {
        report.light(lights[number], number, blocked, new RadianceRGB(weightR * lr, weightG * lg, weightB * lb), shadowRay,
            surface.distance());
      }
      arrive(number, blocked, lr, lg, lb);
    } else if (report != null) {
      report.dark(lights[number], number, LightObserver.Outcome.NOT_REFLECTED);
    }
  }

  /** Adds what a light brings, unless it is blocked. */
  private void arrive(final int number, final boolean blocked, final double lr, final double lg, final double lb) {
    if (depth == 0 && number < Long.SIZE) {
      lit |= (blocked ? 0L : 1L) << number;
      shadowed |= (blocked ? 1L : 0L) << number;
    }
    if (!blocked) {
      sumR += lr;
      sumG += lg;
      sumB += lb;
    }
  }

  /** Pushes the reflected or the refracted ray if its weight is large enough. */
  private void push(final double fr, final double fg, final double fb, final boolean refracted) {
    final double wr = weightR * fr, wg = weightG * fg, wb = weightB * fb;
    final boolean negligible = !(Math.max(wr, Math.max(wg, wb)) >= LEAST_WEIGHT);
    if (negligible || depth >= recursionDepth) {
      if (report != null) {
        report.specular(Ray.NORAY, refracted, negligible ? LightObserver.Fate.NEGLIGIBLE : LightObserver.Fate.TOO_DEEP);
      }
      return;
    }
    final Ray next = refracted ? surface.refracted(specular.ratio(), specular.refractedCosine()) : surface.reflected();
    if (report != null) {
      report.specular(next, refracted, LightObserver.Fate.FOLLOWED);
    }
    waiting.push(next, depth + 1, wr, wg, wb);
  }
}
