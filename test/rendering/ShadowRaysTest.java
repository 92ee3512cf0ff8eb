package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

import org.junit.jupiter.api.Test;

import acceleration.RayTile;
import lights.LightGroup;
import lights.Omnidirectional;
import lights.Spot;
import materials.IdealConductor;
import materials.IdealDielectric;
import materials.Material;
import models.Group3D;
import models.Object3D;
import models.Plane;
import models.RandomNumbers;
import models.Sphere;
import models.TileHits;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;
import tracer.Hit;
import tracer.Ray;
import upnatray.Image;
import view.Camera;
import view.Perspective;

/** Shadow rays as an object sees them that is asked about all of them, and lights of odd number and place. */
class ShadowRaysTest {

  private static final SpectrumRGB WHITE = new SpectrumRGB(1f / 3, 1f / 3, 1f / 3);

  /** An object that nothing hits, and that takes down which rays it is asked about. */
  private static final class Recorder extends Object3D {

    private final Set<String> rays = new TreeSet<>();

    Recorder() {
      super(Color.BLACK);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      rays.add(ray.startX() + " " + ray.startY() + " " + ray.startZ() + " " + ray.directionX() + " " + ray.directionY() + " "
          + ray.directionZ() + " " + ray.blindness());
      return Hit.NOHIT;
    }
  }

  private static int[] pixels(final Group3D scene, final Camera camera, final RenderSettings settings) {
    final Image image = new Image(33, 21, Color.BLACK);
    image.synthesis(scene, camera, settings);
    return image.getRGB(0, 0, 33, 21, null, 0, 33);
  }

  private static Camera camera(final Point3D from, final Point3D to, final Vector3D up) {
    final Camera camera = new Camera(from, to, up);
    camera.setProjection(new Perspective(50, 1.5f));
    return camera;
  }

  /** Start, direction and blindness of all rays, the shadow rays among them, are the same by tiles and one by one. */
  @Test
  void raysOfTilesAreThoseOfSinglePixelsBitForBit() {
    final RandomNumbers numbers = new RandomNumbers("recorded rays");
    for (int i = 0; i < RandomNumbers.times(5); i++) {
      final List<Set<String>> recorded = new ArrayList<>();
      final List<Object3D> objects = LitScenes.objects(numbers);
      final Camera camera = camera(numbers.pointAbout(new Point3D(0, 4, 0), 5), new Point3D(0, 1, 0), numbers.direction());
      for (final boolean byTiles : new boolean[] {false, true}) {
        final Recorder recorder = new Recorder();
        final Group3D scene = new Group3D();
        scene.addObject(recorder);
        objects.forEach(scene::addObject);
        final RenderSettings settings = RenderSettings.STANDARD.withThreads(1)
            .withShading(new Illumination(scene, LitScenes.lights(), 1, LitScenes.SKY));
        pixels(scene, camera, byTiles ? settings : settings.withPixelLoop());
        recorded.add(recorder.rays);
      }
      assertTrue(recorded.get(0).size() > 1000, () -> "rays: " + recorded.get(0).size());
      final Set<String> missing = new TreeSet<>(recorded.get(0));
      missing.removeAll(recorded.get(1));
      recorded.get(1).removeAll(recorded.get(0));
      assertEquals(Set.of(), missing, "rays that tiles do not ask");
      assertEquals(Set.of(), recorded.get(1), "rays that only tiles ask");
    }
  }

  /** What a light lies on does not block it, for a tile of pixels as for one. */
  @Test
  void lampOnACeilingLightsTheFloor() {
    final Group3D scene = new Group3D();
    scene.addObject(new Plane(new Point3D(0, 0, 0), new Vector3D(0, 1, 0), Color.WHITE));
    scene.addObject(new Plane(new Point3D(0, 5, 0), new Vector3D(0, -1, 0), Color.WHITE));
    final Illumination light = new Illumination(scene, new LightGroup(new Omnidirectional(new Point3D(0.3f, 5, 0.1f), WHITE,
        500)), 0, Color.BLACK);
    for (final int pixel : pixels(scene, camera(new Point3D(0.2f, 4, 0.3f), new Point3D(0, 0, 0), new Vector3D(0, 0, -1)),
        RenderSettings.STANDARD.withShading(light))) {
      assertTrue((pixel & 0xff) > 0, "a dark pixel");
    }
  }

  /** Of more than 64 lights the first 64 have bits; all of them light. */
  @Test
  void lightsBeyondTheSixtyFourthHaveNoBitsButLight() {
    final LightGroup lights = new LightGroup();
    for (int i = 0; i < 64; i++) {
      lights.addLight(new Spot(new Point3D(0, 5, 0), new Point3D(0, 9, 0), 20, WHITE, 10));
    }
    for (int i = 0; i < 3; i++) {
      lights.addLight(new Omnidirectional(new Point3D(0, 5, i), WHITE, 100));
    }
    final Group3D scene = new Group3D();
    scene.addObject(new Plane(new Point3D(), new Vector3D(0, 1, 0), Color.WHITE));
    final Illumination illumination = new Illumination(scene, lights, 0, Color.BLACK);
    final Ray ray = new Ray(new Point3D(1, 2, 1), new Point3D());
    final WhittedTracer tracer = illumination.tracer();
    tracer.trace(ray, scene.intersectionWith(ray), LightObserver.NONE);
    assertEquals("0 0", tracer.lit() + " " + tracer.shadowed());
    assertTrue(tracer.r() > 0);
    final RayTile tile = new RayTile();
    tile.open(1, 1);
    tile.put(0, 1, 2, 1, -1, -2, -1);
    tile.close();
    final TileHits hits = new TileHits(tile);
    hits.clear();
    scene.closestHits(tile, hits);
    final LitTile pixels = new LitTile(illumination);
    pixels.prepare(hits, 0, 1, 1);
    assertEquals("0 0", pixels.lit(0) + " " + pixels.shadowed(0));
    assertEquals(illumination.argb(ray, scene.intersectionWith(ray)), pixels.argb(0));
  }

  /** A flat surface seen at a grazing angle keeps its normal, whatever axis that is along: only bent normals are lifted. */
  @Test
  void flatSurfacesKeepTheirNormalsAtGrazingAngles() {
    for (final Vector3D n : new Vector3D[] {new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1),
        new Vector3D(0.6f, 0, 0.8f), new Vector3D(0.6f, 0.8f, 0)}) {
      final Vector3D along = n.y == 0 ? new Vector3D(0, 1, 0) : new Vector3D(0, 0, 1);
      final Group3D scene = new Group3D();
      scene.addObject(new Plane(new Point3D(), n, Color.WHITE));
      final Ray ray = new Ray(new Point3D(-along.x + 1e-4f * n.x, -along.y + 1e-4f * n.y, -along.z + 1e-4f * n.z),
          new Point3D());
      final int[] surfaces = {0};
      new Illumination(scene, new LightGroup(), 0, Color.BLACK).radiance(ray, scene.intersectionWith(ray),
          new LightObserver() {
            @Override
            public void surface(final Surface surface) {
              surfaces[0]++;
              assertEquals(surface.hit().getNormal(), surface.normal());
            }
          });
      assertEquals(1, surfaces[0]);
    }
  }

  /** Fails when it is asked for the first time about a ray that goes up. */
  private static final class OnceWrong extends Object3D {

    private boolean hasFailed;

    OnceWrong() {
      super(Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      if (!hasFailed && ray.directionY() > 0) {
        hasFailed = true;
        throw new ArithmeticException("by a student");
      }
      return Hit.NOHIT;
    }
  }

  /** A ray whose tracing fails leaves nothing behind that the next ray would bring. */
  @Test
  void failureLeavesNothingBehind() {
    final Group3D scene = new Group3D();
    final Material glass = new IdealDielectric(new ReflectanceRGB(1, 1, 1), 1.5f, 1);
    scene.addObject(new Sphere(new Point3D(0, 1, 0), 1, glass));
    final Material mirror = new IdealConductor(new ReflectanceRGB(1, 1, 1));
    scene.addObject(new Plane(new Point3D(0, 9, 0), new Vector3D(0, -1, 0), mirror));
    final Illumination expected = new Illumination(scene, new LightGroup(), 6, LitScenes.SKY);
    final Ray ray = new Ray(new Point3D(4, 5, 3), new Point3D(0, 1.2f, 0.1f));
    final Hit hit = scene.intersectionWith(ray);
    final RadianceRGB radiance = expected.radiance(ray, hit, LightObserver.NONE);
    scene.addObject(new OnceWrong());
    final Illumination light = new Illumination(scene, new LightGroup(), 6, LitScenes.SKY);
    boolean failed = false;
    try {
      light.radiance(ray, hit, LightObserver.NONE);
    } catch (final RuntimeException failure) {
      failed = true;
    }
    assertTrue(failed);
    assertEquals(radiance.toString(), light.radiance(ray, hit, LightObserver.NONE).toString());
  }
}
