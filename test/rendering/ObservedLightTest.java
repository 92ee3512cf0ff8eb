package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

import org.junit.jupiter.api.Test;

import acceleration.RayTile;
import acceleration.SegmentTile;
import lights.Light;
import materials.BTDF;
import models.Group3D;
import models.RandomNumbers;
import models.TileHits;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import tracer.Hit;
import tracer.Ray;
import view.Camera;
import view.Perspective;

/** The reports to an observer agree with the lights, the materials and the objects themselves. */
class ObservedLightTest {

  private static double largest(final RadianceRGB radiance) {
    return Math.max(radiance.getR(), Math.max(radiance.getG(), radiance.getB()));
  }

  private static void assertProduct(final RadianceRGB a, final RadianceRGB b, final RadianceRGB product) {
    assertEquals(a.getR() * b.getR(), product.getR(), 1e-12 * (1 + product.getR()));
    assertEquals(a.getG() * b.getG(), product.getG(), 1e-12 * (1 + product.getG()));
    assertEquals(a.getB() * b.getB(), product.getB(), 1e-12 * (1 + product.getB()));
  }

  /** Checks the reports about one primary ray. */
  private static final class Checker implements LightObserver {

    private final Group3D scene;
    private final List<Light> lights;
    private final int recursionDepth;
    private final Map<Outcome, Integer> outcomes;
    private final Map<Fate, Integer> fates;
    /** The rays that have been made and not been traced yet: the weight of each. */
    private final Map<Ray, RadianceRGB> awaited = new IdentityHashMap<>();
    private final Map<Ray, Integer> depths = new IdentityHashMap<>();
    private Surface surface;
    /** How many lights have been reported at the surface. */
    private int reported;

    Checker(final Group3D scene, final List<Light> lights, final int recursionDepth, final Ray first,
        final Map<Outcome, Integer> outcomes, final Map<Fate, Integer> fates) {
      this.scene = scene;
      this.lights = lights;
      this.recursionDepth = recursionDepth;
      this.outcomes = outcomes;
      this.fates = fates;
      awaited.put(first, new RadianceRGB(1, 1, 1));
      depths.put(first, 0);
    }

    @Override
    public void surface(final Surface its) {
      assertTrue(surface == null || reported == lights.size(), "each light is reported");
      reported = 0;
      surface = its;
      assertEquals(awaited.remove(its.ray()).toString(), its.weight().toString());
      assertEquals(depths.get(its.ray()), its.depth());
      final Hit hit = scene.intersectionWith(its.ray());
      assertEquals(hit.distance(), its.hit().distance());
      final Vector3D n = its.normal(), d = its.ray().getDirection(), g = hit.getGeometricNormal();
      assertEquals(1, n.length(), 1e-6);
      assertTrue(n.dot(d) < 1e-6, "the normal is on the viewer's side");
      assertTrue(Math.abs(g.dot(d)) < 1e-6 || its.isOutside() == g.dot(d) < 0);
    }

    @Override
    public void background(final Ray ray, final int depth, final RadianceRGB radiance) {
      final RadianceRGB weight = awaited.remove(ray);
      assertEquals(depths.get(ray), depth);
      assertFalse(scene.intersectionWith(ray).hits());
      final RadianceRGB sky = new Illumination(scene, new lights.LightGroup(), 0, LitScenes.SKY).backgroundRadiance();
      assertProduct(weight, sky, radiance);
    }

    @Override
    public void light(final Contribution its) {
      outcomes.merge(its.outcome(), 1, Integer::sum);
      assertEquals(reported++, its.number());
      assertSame(lights.get(its.number()), its.light());
      final Point3D P = surface.hit().getPoint(), S = its.light().getPosition(P);
      final RadianceRGB E = its.light().getIrradianceAt(P);
      final boolean isLit = largest(E) > 0, isFar = its.outcome() == Outcome.OUTSIDE_FIELD;
      assertEquals(isFar, !isLit);
      assertEquals(largest(E), largest(its.irradiance()), 1e-4 * largest(E));
      final Vector3D wi = its.light().getIncidenceDirection(P);
      final double ci = surface.normal().dot(wi);
      assertEquals(isFar ? 0 : Math.abs(ci), its.cosine(), 1e-4);
      final boolean isTraced = its.outcome() == Outcome.LIT || its.outcome() == Outcome.BLOCKED;
      assertEquals(isTraced, its.shadowRay() != Ray.NORAY);
      assertEquals(isFar ? 0 : S.distance(P), its.distance(), 1e-4 * (1 + S.distance(P)));
      assertTrue(its.outcome() != Outcome.BEHIND || ci < 1e-3 || isBehindFacet(wi));
      assertProduct(surface.weight(), its.reflected(), its.radiance());
      assertEquals(isTraced, largest(its.reflected()) > 0);
      if (isTraced) {
        final Ray ray = its.shadowRay();
        assertEquals(its.outcome() == Outcome.BLOCKED, scene.intersectAny(ray, its.distance() * (1 - 1e-9)));
        final double tolerance = S.equals(its.light().getPosition()) ? 1e-9 : 1e-5;
        assertEquals(S.x, ray.startX() + its.distance() * ray.directionX(), tolerance, "the ray ends at the light");
        assertEquals(S.y, ray.startY() + its.distance() * ray.directionY(), tolerance);
        assertEquals(S.z, ray.startZ() + its.distance() * ray.directionZ(), tolerance);
      }
    }

    private boolean isBehindFacet(final Vector3D wi) {
      return (surface.isOutside() ? 1 : -1) * surface.hit().getGeometricNormal().dot(wi) < 1e-3;
    }

    @Override
    public void specular(final Specular its) {
      fates.merge(its.fate(), 1, Integer::sum);
      final RadianceRGB weight = surface.weight(), factor = its.factor();
      final double most = Math.max(weight.getR() * factor.getR(),
          Math.max(weight.getG() * factor.getG(), weight.getB() * factor.getB()));
      assertEquals(its.fate() == Fate.FOLLOWED, its.ray() != Ray.NORAY);
      switch (its.fate()) {
        case FOLLOWED -> {
          assertTrue(most >= 1e-6 && surface.depth() < recursionDepth);
          awaited.put(its.ray(), new RadianceRGB(weight.getR() * factor.getR(), weight.getG() * factor.getG(),
              weight.getB() * factor.getB()));
          depths.put(its.ray(), surface.depth() + 1);
        }
        case TOO_DEEP -> assertTrue(most >= 1e-6 && surface.depth() == recursionDepth);
        case NEGLIGIBLE -> assertTrue(most < 1e-6);
        default -> {
          final double cosine = -surface.normal().dot(surface.ray().getDirection());
          assertTrue(its.isRefracted());
          assertEquals(1, ((BTDF) surface.material()).getReflectance(Math.min(1, cosine), surface.isOutside()), 1e-5);
        }
      }
    }
  }

  /** The lights of one outcome at the first hit of a ray, as bits. */
  private static long lightsOf(final LightObserver.Outcome outcome, final Illumination illumination, final Ray ray,
      final Hit hit) {
    final long[] bits = {0};
    illumination.radiance(ray, hit, new LightObserver() {

      private int depth;

      @Override
      public void surface(final Surface surface) {
        depth = surface.depth();
      }

      @Override
      public void light(final Contribution its) {
        bits[0] |= depth == 0 && its.outcome() == outcome ? 1L << its.number() : 0;
      }
    });
    return bits[0];
  }

  /** Which lights bring something to a pixel of a tile, and which are blocked, is what its ray reports. */
  @Test
  void lightsOfAPixelAreThoseThatItsRayReports() {
    final RandomNumbers numbers = new RandomNumbers("lights of pixels");
    int litPixels = 0;
    for (int n = 0; n < RandomNumbers.times(10); n++) {
      final Group3D scene = new Group3D();
      LitScenes.objects(numbers).forEach(scene::addObject);
      final Illumination illumination = new Illumination(scene, LitScenes.lights(), n % 3, LitScenes.SKY);
      final Point3D eye = numbers.pointAbout(new Point3D(0, 4, 0), 5);
      final Camera camera = new Camera(eye, new Point3D(0, 1, 0), numbers.direction());
      camera.setProjection(new Perspective(50, 1));
      final RayTile tile = new RayTile();
      tile.open(RayTile.SIZE, RayTile.SIZE);
      camera.getRayGenerator(RayTile.SIZE, RayTile.SIZE).fill(tile, 0, 0);
      tile.close();
      final TileHits hits = new TileHits(tile);
      hits.clear();
      scene.closestHits(tile, hits);
      final LitTile pixels = new LitTile(illumination);
      final int size = SegmentTile.SIZE, corner = numbers.index(2) * size + numbers.index(2) * size * RayTile.SIZE;
      pixels.prepare(hits, numbers.index(size), size, size);
      pixels.prepare(hits, corner, size, size);
      for (int k = 0; k < size * size; k++) {
        final int i = corner + k % size + k / size * RayTile.SIZE;
        final Hit hit = hits.hit(i);
        assertEquals(hit.hits(), pixels.hits(i));
        if (hit.hits()) {
          final long lit = lightsOf(LightObserver.Outcome.LIT, illumination, hits.ray(i), hit);
          final long blocked = lightsOf(LightObserver.Outcome.BLOCKED, illumination, hits.ray(i), hit);
          final WhittedTracer tracer = illumination.tracer();
          tracer.trace(hits.ray(i), hit, LightObserver.NONE);
          assertEquals(lit + " " + blocked, pixels.lit(i) + " " + pixels.shadowed(i));
          assertEquals(lit + " " + blocked, tracer.lit() + " " + tracer.shadowed());
          assertEquals(illumination.argb(hits.ray(i), hit), pixels.argb(i));
          assertEquals(hit.distance(), pixels.hit(i).distance());
          litPixels += lit != 0 ? 1 : 0;
        }
      }
    }
    assertTrue(litPixels > 500, "lit pixels: " + litPixels);
  }

  @Test
  void everyStepIsReportedAsItIs() {
    final RandomNumbers numbers = new RandomNumbers("observed light");
    final Map<LightObserver.Outcome, Integer> outcomes = new EnumMap<>(LightObserver.Outcome.class);
    final Map<LightObserver.Fate, Integer> fates = new EnumMap<>(LightObserver.Fate.class);
    for (int i = 0; i < RandomNumbers.times(12); i++) {
      final Group3D scene = new Group3D();
      LitScenes.objects(numbers).forEach(scene::addObject);
      final int depth = i % 4 == 3 ? 12 : i % 4;
      final Illumination illumination = new Illumination(scene, LitScenes.lights(), depth, LitScenes.SKY);
      for (int k = 0; k < 150; k++) {
        final Ray ray = new Ray(numbers.pointAbout(new Point3D(0, 3, 0), 6), numbers.pointAbout(new Point3D(0, 1, 0), 1.5));
        final Checker checker = new Checker(scene, illumination.lights(), depth, ray, outcomes, fates);
        illumination.radiance(ray, scene.intersectionWith(ray), checker);
        assertTrue(checker.awaited.isEmpty(), () -> "every ray that was made is traced; " + numbers);
      }
    }
    for (final LightObserver.Outcome outcome : LightObserver.Outcome.values()) {
      assertTrue(outcomes.getOrDefault(outcome, 0) > 20, () -> outcome + " of " + outcomes);
    }
    for (final LightObserver.Fate fate : LightObserver.Fate.values()) {
      assertTrue(fates.getOrDefault(fate, 0) > 5, () -> fate + " of " + fates);
    }
  }
}
