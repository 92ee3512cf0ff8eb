package rendering;

import static arguments.Arguments.notNull;

import java.awt.Color;
import java.util.Arrays;

import arguments.Messages;
import lights.Incidence;
import lights.Light;
import materials.Material;
import materials.SpecularRays;
import materials.SurfaceInteraction;
import models.Group3D;
import models.Object3D;
import models.ShadowTile;
import primitives.Point3D;
import radiometry.RadianceRGB;
import tracer.Hit;
import tracer.Ray;

/**
 * Finds the radiance along a ray for {@link Illumination}: shades its hit, then follows the reflected and refracted rays
 * that were made there, and so on, until none is left. Those that wait are kept in a stack of its own, never more than
 * their greatest depth plus one, so that facing mirrors do not fill that of Java. One for each thread; nothing
 * is allocated on the way but rays and hits.
 */
final class WhittedTracer {

  /** A ray whose weight in the largest channel is below this brings nothing that could be seen. */
  private static final double LEAST_WEIGHT = 1e-6;

  /** Part of the way to a light in which an object blocks it: what the light itself lies on does not. */
  private static final double BEFORE_LIGHT = 1 - 1e-9;

  /** Lights whose shadow rays are asked together for a tile. */
  private static final int MOST_SHADOW_TILES = 64;

  private final Group3D scene;
  private final Light[] lights;
  private final int recursionDepth;
  private final RadianceRGB background;
  private final MatteMaterials matte = new MatteMaterials();
  private final Incidence incidence = new Incidence();
  private final SurfaceInteraction interaction = new SurfaceInteraction();
  private final SpecularRays specular = new SpecularRays();
  private final ViewedSurface surface = new ViewedSurface();

  /**
   * For each of the first lights the shadow rays of the tile at hand, made for the first tile; those of further lights are
   * asked one by one, so that many lights do not take much memory.
   */
  private ShadowTile[] shadows = {};
  /** The pixel that is traced; −1 if it belongs to no tile. */
  private int pixel = -1;

  private Ray[] waiting = new Ray[16];
  private int[] depths = new int[16];
  private double[] weights = new double[3 * 16];
  private int end;

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
  private long lit;
  private long shadowed;

  WhittedTracer(final Illumination illumination) {
    this.scene = illumination.scene();
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
    pixel = -1;
    trace(first, hit);
  }

  /** Finds the radiance of the ray of a pixel whose shadows are known: see {@link #castShadows}. */
  void trace(final int itsPixel, final Ray first, final Hit hit) {
    report = null;
    pixel = itsPixel;
    trace(first, hit);
  }

  private void trace(final Ray first, final Hit hit) {
    r = 0;
    g = 0;
    b = 0;
    lit = 0;
    shadowed = 0;
    end = 0;
    take(first, 0, 1, 1, 1);
    follow(hit);
    while (end > 0) {
      end--;
      take(waiting[end], depths[end], weights[3 * end], weights[3 * end + 1], weights[3 * end + 2]);
      follow(closestHit());
    }
  }

  private void follow(final Hit hit) {
    if (hit.hits()) {
      shade(hit);
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

  /** Forgets the shadow rays of the tile before. */
  void clearShadows() {
    if (shadows.length == 0) {
      shadows = new ShadowTile[Math.min(lights.length, MOST_SHADOW_TILES)];
      Arrays.setAll(shadows, i -> new ShadowTile());
    }
    for (final ShadowTile shadow : shadows) {
      shadow.clear();
    }
  }

  /** Casts the shadow rays of a pixel's first hit, to be asked together with those of other pixels of its tile. */
  void castShadows(final int itsPixel, final Ray first, final Hit hit) {
    if (!hit.hits()) {
      return;
    }
    ray = first;
    surface.set(first, hit);
    final Material material = hit.getObject().getMaterial();
    final boolean transmits = material != null && material.transmits();
    if (material != null && !material.scatters()) {
      return;
    }
    for (int i = 0; i < shadows.length; i++) {
      if (illuminate(lights[i], hit)) {
        final double wx = incidence.directionX(), wy = incidence.directionY(), wz = incidence.directionZ();
        final double ci = wx * surface.normalX() + wy * surface.normalY() + wz * surface.normalZ();
        final double facing = surface.facing(wx, wy, wz);
        if (ci > 0 && facing > 0 || ci < 0 && facing < 0 && transmits) {
          final Ray shadowRay = surface.towards(facing > 0, wx, wy, wz, incidence.distance());
          shadows[i].put(itsPixel, shadowRay, surface.distance(), surface.distance() * BEFORE_LIGHT);
        }
      }
    }
  }

  /** Finds which of the shadow rays are blocked. */
  void findShadows() {
    for (final ShadowTile shadow : shadows) {
      shadow.findBlocked(scene);
    }
  }

  private Hit closestHit() {
    try {
      return scene.intersectionWith(ray);
    } catch (RuntimeException | StackOverflowError failure) {
      throw TracingFailure.ofScene(ray, failure);
    }
  }

  /** Adds what the lights bring to a hit of the ray at hand, and makes the rays that leave it. */
  private void shade(final Hit hit) {
    surface.set(ray, hit);
    final Material material = material(hit);
    interaction.setView(surface.normalX(), surface.normalY(), surface.normalZ(),
        -ray.directionX(), -ray.directionY(), -ray.directionZ(), surface.isSeenFromOutside());
    if (report != null) {
      report.surface(new LightObserver.Surface(ray, hit, depth, new RadianceRGB(weightR, weightG, weightB),
          material, surface.normal(), surface.isSeenFromOutside()));
    }
    if (material.scatters() || report != null) {
      for (int i = 0; i < lights.length; i++) {
        if (illuminate(lights[i], hit)) {
          addLight(i, material);
        } else if (report != null) {
          report.dark(lights[i], i, LightObserver.Outcome.OUTSIDE_FIELD);
        }
      }
    }
    if ((depth < recursionDepth || report != null) && isSpecular(material)) {
      await(specular.refractedR(), specular.refractedG(), specular.refractedB(), true);
      await(specular.reflectedR(), specular.reflectedG(), specular.reflectedB(), false);
    }
  }

  /** The material of a hit's object; if it has none, it is matte, of its colour there. */
  private Material material(final Hit hit) {
    final Object3D object = hit.getObject();
    final Material material = object.getMaterial();
    if (material != null) {
      return material;
    }
    try {
      final Color color = object.getColorAt(hit);
      return matte.of(notNull("color", color));
    } catch (RuntimeException | StackOverflowError failure) {
      throw TracingFailure.of(object, "getColorAt", ray, failure);
    }
  }

  private boolean illuminate(final Light light, final Hit hit) {
    final double x = hit.pointX(), y = hit.pointY(), z = hit.pointZ();
    try {
      return light.illuminate(x, y, z, incidence);
    } catch (RuntimeException | StackOverflowError failure) {
      final boolean isNull = failure instanceof IllegalStateException && isPositionAtFault(light, x, y, z);
      throw TracingFailure.of(light, isNull ? "getPosition" : "getIrradianceAt", ray, failure);
    }
  }

  private static boolean isPositionAtFault(final Light light, final double x, final double y, final double z) {
    try {
      return light.getIrradianceAt(new Point3D((float) x, (float) y, (float) z)) != null;
    } catch (RuntimeException | StackOverflowError irradianceFails) {
      return false;
    }
  }

  /** Adds what the surface sends along the ray of the light that falls in, unless it is zero or something blocks it. */
  private void addLight(final int number, final Material material) {
    final double wx = incidence.directionX(), wy = incidence.directionY(), wz = incidence.directionZ();
    interaction.setIncident(wx, wy, wz);
    final double ci = interaction.cosineIn(), facing = surface.facing(wx, wy, wz);
    final boolean before = ci > 0 && facing > 0;
    if (!before && !(ci < 0 && facing < 0 && material.transmits())) {
      if (report != null) {
        report.dark(lights[number], number, LightObserver.Outcome.BEHIND);
      }
      return;
    }
    if (!material.scatters()) {
      report.dark(lights[number], number, LightObserver.Outcome.NOT_REFLECTED);
      return;
    }
    final double k = Math.abs(ci);
    interaction.setIrradiance(k * incidence.irradianceR(), k * incidence.irradianceG(), k * incidence.irradianceB());
    scatter(material);
    final double lr = weightR * interaction.radianceR(), lg = weightG * interaction.radianceG(),
        lb = weightB * interaction.radianceB();
    if (lr > 0 || lg > 0 || lb > 0) {
      if (depth == 0 && pixel >= 0 && number < shadows.length && shadows[number].holds(pixel)) {
        arrive(number, shadows[number].isBlocked(pixel), lr, lg, lb);
        return;
      }
      final Ray shadowRay = surface.towards(before, wx, wy, wz, incidence.distance());
      final boolean blocked = isBlocked(shadowRay, surface.distance() * BEFORE_LIGHT);
      if (report != null) {
        report.light(lights[number], number, blocked, new RadianceRGB(lr, lg, lb), shadowRay, surface.distance());
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
      add(lr, lg, lb);
    }
  }

  private void scatter(final Material material) {
    try {
      material.scatter(interaction);
      final double sr = interaction.radianceR(), sg = interaction.radianceG(), sb = interaction.radianceB();
      if (!(sr >= 0 && sg >= 0 && sb >= 0 && sr + sg + sb < Double.POSITIVE_INFINITY)) {
        throw new IllegalStateException(Messages.text("rendering.wrongRadiance", sr, sg, sb));
      }
    } catch (RuntimeException | StackOverflowError failure) {
      throw TracingFailure.of(material, "reflect", ray, failure);
    }
  }

  private boolean isBlocked(final Ray shadowRay, final double distance) {
    try {
      return scene.intersectAny(shadowRay, distance);
    } catch (RuntimeException | StackOverflowError failure) {
      throw TracingFailure.ofScene(shadowRay, failure);
    }
  }

  private boolean isSpecular(final Material material) {
    try {
      return material.specular(Math.max(0, Math.min(1, interaction.cosineOut())), surface.isSeenFromOutside(), specular);
    } catch (RuntimeException | StackOverflowError failure) {
      throw TracingFailure.of(material, "mirror", ray, failure);
    }
  }

  /** Puts the reflected or the refracted ray among those that wait, if its weight is worth it. */
  private void await(final double fr, final double fg, final double fb, final boolean refracted) {
    final double wr = weightR * fr, wg = weightG * fg, wb = weightB * fb;
    final boolean negligible = !(Math.max(wr, Math.max(wg, wb)) >= LEAST_WEIGHT);
    if (negligible || depth >= recursionDepth) {
      if (report != null) {
        report.specular(Ray.NORAY, refracted, negligible ? LightObserver.Fate.NEGLIGIBLE : LightObserver.Fate.TOO_DEEP);
      }
      return;
    }
    if (end == waiting.length) {
      waiting = Arrays.copyOf(waiting, 2 * end);
      depths = Arrays.copyOf(depths, 2 * end);
      weights = Arrays.copyOf(weights, 6 * end);
    }
    waiting[end] = refracted ? surface.refracted(specular.ratio(), specular.refractedCosine()) : surface.reflected();
    if (report != null) {
      report.specular(waiting[end], refracted, LightObserver.Fate.FOLLOWED);
    }
    depths[end] = depth + 1;
    weights[3 * end] = wr;
    weights[3 * end + 1] = wg;
    weights[3 * end + 2] = wb;
    end++;
  }
}
