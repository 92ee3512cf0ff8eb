package inspection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.geom.Point2D;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import lights.LightGroup;
import lights.Omnidirectional;
import lights.Spot;
import materials.GGX;
import materials.IdealConductor;
import materials.IdealDielectric;
import materials.Lambertian;
import materials.ReflectiveCookTorrance;
import models.AffineTransformation;
import models.Box;
import models.Group3D;
import models.Object3D;
import models.Plane;
import models.Sphere;
import models.TriangularMesh;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;
import radiometry.SpectrumRGB;
import rendering.LightObserver;
import rendering.Progress;
import rendering.RenderPass;
import scenes.Lighting;
import scenes.SceneFile;
import tracer.Hit;
import upnatray.RenderJob;
import view.Angular;
import view.Camera;
import view.FishEye;
import view.Orthographic;
import view.Perspective;
import view.Projection;

class LightTreeTest {

  private static final int W = 48;
  private static final int H = 36;
  private static final SpectrumRGB WARM = new SpectrumRGB(0.5f, 0.3f, 0.2f);
  private static final Sphere MATTE = new Sphere(new Point3D(0, 1, 0), 1, Color.RED);

  static SceneFile lit(final Projection projection) {
    final Group3D objects = new Group3D();
    objects.addObject(MATTE);
    objects.addObject(new Plane(new Point3D(), new Vector3D(0, 1, 0), new Lambertian(new ReflectanceRGB(0.6f, 0.6f, 0.5f))));
    objects.addObject(new Sphere(new Point3D(-2.2f, 1, 0), 1, new IdealConductor(new ReflectanceRGB(0.9f, 0.8f, 0.7f))));
    objects.addObject(new Sphere(new Point3D(2.2f, 1, 0.5f), 1, new IdealDielectric(new ReflectanceRGB(1, 1, 1), 1.5f, 1)));
    objects.addObject(new Sphere(new Point3D(0.7f, 0.4f, 1.8f), 0.4f, new ReflectiveCookTorrance(
        new ReflectanceRGB(0.2f, 0.3f, 0.4f), new ReflectanceRGB(0.4f, 0.4f, 0.4f), new GGX(20))));
    objects.addObject(new Box(new Point3D(-0.8f, 0.5f, 2.5f), new Vector3D(1, 0, 0.4f), new Vector3D(0, 1, 0), 0.8f, 0.8f,
        0.8f, new IdealDielectric(new ReflectanceRGB(1, 1, 1), 1.5f, 1)));
    final LightGroup lights = new LightGroup(new Omnidirectional(new Point3D(3, 5, 4), WARM, 60),
        new Spot(new Point3D(-3, 4, 3), new Point3D(), 14, new SpectrumRGB(1, 0, 0), 8));
    final Camera camera = new Camera(new Point3D(0, 2.5f, 8), new Point3D(0, 1, 0), new Vector3D(0, 1, 0));
    camera.setProjection(projection);
    return new SceneFile("lit", W, H, new Color(90, 120, 200), new Lighting(true, false, lights, 4, 0.5), camera, objects,
        Map.of(MATTE, "ball"), Set.of());
  }

  private static void assertClose(final RadianceRGB expected, final RadianceRGB actual, final String text) {
    final double tolerance = 1e-12 * (1e-3 + expected.getR() + expected.getG() + expected.getB());
    assertEquals(expected.getR(), actual.getR(), tolerance, text);
    assertEquals(expected.getG(), actual.getG(), tolerance, text);
    assertEquals(expected.getB(), actual.getB(), tolerance, text);
  }

  private static RadianceRGB product(final RadianceRGB a, final RadianceRGB b) {
    return new RadianceRGB(a.getR() * b.getR(), a.getG() * b.getG(), a.getB() * b.getB());
  }

  /**
   * Every outcome of a light and every fate of a ray occurs, and all numbers multiply and add up to the pixel of the
   * picture.
   */
  @Test
  void theTreeOfEveryPixelAddsUpToThePicture() {
    final SceneFile scene = lit(new Perspective(45, 4f / 3));
    final RenderJob job = new RenderJob(scene, RenderPass.COLOUR, W, H, 1);
    assertTrue(job.run(Progress.NONE));
    final Inspector inspector = new Inspector(scene, W, H);
    final Map<LightObserver.Outcome, Integer> outcomes = new EnumMap<>(LightObserver.Outcome.class);
    final Map<LightObserver.Fate, Integer> fates = new EnumMap<>(LightObserver.Fate.class);
    for (int m = 0; m < W; m++) {
      for (int n = 0; n < H; n++) {
        final Inspection inspection = inspector.inspect(m, n);
        final String pixel = "(" + m + ", " + n + ")";
        assertEquals(job.image().getRGB(m, H - 1 - n), inspection.argb(), pixel);
        assertEquals(inspection.winner().isPresent(), inspection.light().isPresent(), pixel);
        inspection.light().ifPresent(light -> {
          assertClose(light.radiance(), light.root().radiance(), pixel);
          check(light.root(), pixel, outcomes, fates);
        });
      }
    }
    outcomes.remove(LightObserver.Outcome.NOT_REFLECTED);
    assertEquals(LightObserver.Outcome.values().length - 1, outcomes.size(), outcomes::toString);
    fates.remove(LightObserver.Fate.NEGLIGIBLE);
    assertEquals(LightObserver.Fate.values().length - 1, fates.size(), fates::toString);
  }

  private static void check(final LightNode node, final String pixel, final Map<LightObserver.Outcome, Integer> outcomes,
      final Map<LightObserver.Fate, Integer> fates) {
    final LightObserver.Surface surface = node.surface();
    for (final LightNode.Lamp lamp : node.lights()) {
      final LightObserver.Contribution light = lamp.contribution();
      outcomes.merge(light.outcome(), 1, Integer::sum);
      assertClose(product(surface.weight(), light.reflected()), light.radiance(), pixel + light);
      assertEquals(light.outcome() == LightObserver.Outcome.BLOCKED, lamp.blocker().isPresent(), pixel + light);
      if (surface.material() instanceof Lambertian && light.outcome() == LightObserver.Outcome.LIT) {
        final RadianceRGB f = light.reflected();
        final double k = f.getR() / (light.irradiance().getR() * light.cosine()) * Math.PI;
        assertTrue(k > 0 && k <= 1.0001, pixel + light);
      }
    }
    for (final LightNode.Branch branch : node.branches()) {
      fates.merge(branch.specular().fate(), 1, Integer::sum);
      final boolean followed = branch.specular().fate() == LightObserver.Fate.FOLLOWED;
      assertEquals(followed, branch.target().isPresent() || branch.background().isPresent(), pixel + branch);
      branch.target().ifPresent(target -> {
        assertSame(branch.specular().ray(), target.ray());
        assertEquals(surface.depth() + 1, target.surface().depth());
        assertClose(branch.weight(), target.surface().weight(), pixel);
        check(target, pixel, outcomes, fates);
      });
    }
  }

  @Test
  void whatBlocksALightIsNamedWithItsPoint() {
    final SceneFile scene = lit(new Perspective(45, 4f / 3));
    final Inspector inspector = new Inspector(scene, W, H);
    int blocked = 0;
    for (int i = 0; i < W * H; i++) {
      final Inspection inspection = inspector.inspect(i % W, i / W);
      for (final LightNode.Lamp lamp : inspection.light().map(light -> light.root().lights()).orElse(List.of())) {
        if (lamp.blocker().isPresent() && lamp.blocker().get().object() == MATTE) {
          blocked++;
          assertEquals(1, lamp.blocker().get().point().distance(new Point3D(0, 1, 0)), 1e-4);
          assertEquals(1, LightRays.of(lamp).size());
        }
      }
    }
    assertTrue(blocked > 0);
  }

  /** The lights at a mirror and at glass bring nothing, for a reason that is reported. */
  @Test
  void everyLightIsListedAtEverySurface() {
    final SceneFile scene = lit(new Perspective(45, 4f / 3));
    final Inspector inspector = new Inspector(scene, W, H);
    int ideal = 0;
    for (int i = 0; i < W * H; i++) {
      final Optional<LightNode> root = inspector.inspect(i % W, i / W).light().map(PixelLight::root);
      ideal += root.map(LightTreeTest::countAndCheckIdeal).orElse(0);
    }
    assertTrue(ideal > 100, "ideal surfaces: " + ideal);
  }

  private static int countAndCheckIdeal(final LightNode node) {
    assertEquals(2, node.lights().size());
    final boolean isIdeal = !node.surface().material().scatters();
    for (final LightNode.Lamp lamp : node.lights()) {
      final LightObserver.Outcome outcome = lamp.contribution().outcome();
      assertTrue(!isIdeal || outcome == LightObserver.Outcome.NOT_REFLECTED || outcome == LightObserver.Outcome.BEHIND
          || outcome == LightObserver.Outcome.OUTSIDE_FIELD, outcome::toString);
      assertTrue(!isIdeal || lamp.contribution().radiance().getR() == 0);
    }
    return (isIdeal ? 1 : 0) + node.branches().stream().flatMap(branch -> branch.target().stream())
        .mapToInt(LightTreeTest::countAndCheckIdeal).sum();
  }

  /** A triangle of a mesh and a transformed ball belong to objects of the scene, as surfaces and as what blocks a light. */
  @Test
  void surfacesAndBlockersBelongToObjectsOfTheScene() {
    final TriangularMesh mesh = TriangularMesh.of(new float[] {-2, 0, -2, 2, 0, -2, 2, 0, 2, -2, 0, 2},
        new int[] {0, 2, 1, 0, 3, 2}, Color.GRAY);
    final AffineTransformation ball = new AffineTransformation(new Vector3f(0, 1, 0), 40,
        new Sphere(new Point3D(0, 1.5f, 0), 0.5f, Color.RED));
    final Group3D within = new Group3D(), objects = new Group3D();
    within.addObject(ball);
    objects.addObject(mesh);
    objects.addObject(within);
    final Camera camera = new Camera(new Point3D(0, 2.5f, 6), new Point3D(0, 0.5f, 0), new Vector3D(0, 1, 0));
    camera.setProjection(new Perspective(45, 4f / 3));
    final SceneFile scene = new SceneFile("", W, H, Color.BLUE, new Lighting(true, false,
        new LightGroup(new Omnidirectional(new Point3D(0, 5, 0), WARM, 60)), 1, 0), camera, objects, Map.of(), Set.of());
    final Inspector inspector = new Inspector(scene, W, H);
    int blocked = 0;
    final Set<Object3D> surfaces = new HashSet<>();
    for (int i = 0; i < W * H; i++) {
      final Optional<LightNode> root = inspector.inspect(i % W, i / W).light().map(PixelLight::root);
      root.ifPresent(node -> surfaces.add(node.sceneObject()));
      if (root.isPresent() && root.get().sceneObject() == mesh && root.get().lights().get(0).blocker().isPresent()) {
        assertSame(ball, root.get().lights().get(0).blocker().get().sceneObject());
        blocked++;
      }
    }
    assertEquals(Set.of(mesh, ball), surfaces);
    assertTrue(blocked > 5, "blocked: " + blocked);
  }

  @Test
  void hitsAreProjectedIntoTheirPixel() {
    for (final Projection projection : List.of(new Perspective(45, 4f / 3), new Orthographic(6, 0.75f), new Angular(120),
        new FishEye(150))) {
      final SceneFile scene = lit(projection);
      final PixelProjector projector = new PixelProjector(scene.camera(), W, H);
      int hits = 0;
      for (int m = 0; m < W; m++) {
        for (int n = 0; n < H; n++) {
          final Hit hit = scene.objects().intersectionWith(scene.camera().getRayGenerator(W, H).getRay(m, n));
          if (hit.hits()) {
            hits++;
            final Point2D place = projector.project(hit.getPoint()).orElseThrow();
            assertEquals(m + 0.5, place.getX(), 1e-3, projection::toString);
            assertEquals(H - n - 0.5, place.getY(), 1e-3, projection::toString);
          }
        }
      }
      assertTrue(hits > 100);
    }
  }

  @Test
  void theAlbedoOfALambertianIsItsReflectanceAndOfAMirrorItsFactor() {
    final ReflectanceRGB k = new ReflectanceRGB(0.2f, 0.5f, 0.8f);
    for (final double cosine : new double[] {1, 0.7, 0.1}) {
      final BrdfSlice matte = BrdfSlice.of(new Lambertian(k), cosine, true);
      assertEquals(0.5, matte.albedo().getG(), 2e-3);
      assertEquals(0.2 / Math.PI, matte.values().get(360).getR(), 1e-6);
      assertEquals(0.8, BrdfSlice.of(new IdealConductor(k), cosine, true).albedo().getB(), 1e-6);
      final BrdfSlice rough = BrdfSlice.of(new ReflectiveCookTorrance(k, new ReflectanceRGB(0.2f, 0.2f, 0.2f),
          new GGX(3)), cosine, true);
      assertTrue(rough.albedo().getG() > 0.6 && rough.albedo().getG() < 1.001, rough.albedo()::toString);
    }
  }
}
