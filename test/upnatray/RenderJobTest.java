package upnatray;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;

import acceleration.RayTile;
import inspection.SampleScenes;
import models.Cost;
import models.Object3D;
import models.Sphere;
import org.junit.jupiter.api.Test;
import primitives.Point3D;
import primitives.Vector3D;
import rendering.ColourScale;
import rendering.Progress;
import rendering.RenderPass;
import rendering.RenderSettings;
import rendering.Shading;
import scenes.SceneFile;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import view.Orthographic;
import view.Perspective;

class RenderJobTest {

  private static final int W = 100;
  private static final int H = 80;

  private static SceneFile everyShape() {
    return SampleScenes.of(new Perspective(45, 1.25f), true, SampleScenes.everyShape());
  }

  private static RenderJob done(final SceneFile scene, final RenderPass view) {
    final RenderJob job = new RenderJob(scene, view, W, H, 2);
    assertTrue(job.run(Progress.NONE));
    return job;
  }

  /** At edges a pixel is that of all samples or that of one. */
  @Test
  void aJobIsRefinedByMoreRaysForItsPixels() {
    final RenderJob one = done(everyShape(), RenderPass.COLOUR);
    final RenderJob all = one.refined(3, false), edges = one.refined(3, true);
    assertTrue(all.run(Progress.NONE) && edges.run(Progress.NONE));
    assertEquals(3, all.samples());
    assertTrue(edges.isAtEdges() && !all.isAtEdges());
    int refined = 0, left = 0;
    for (int i = 0; i < W * H; i++) {
      final int x = i % W, y = i / W;
      final int a = one.image().getRGB(x, y), b = all.image().getRGB(x, y), c = edges.image().getRGB(x, y);
      assertTrue(c == a || c == b, x + ", " + y);
      refined += a != b && c == b ? 1 : 0;
      left += a != b && c == a ? 1 : 0;
    }
    assertTrue(refined > 100 && left > 10, refined + ", " + left);
    for (final RenderPass numbers : List.of(RenderPass.DEPTH, RenderPass.COST)) {
      assertThrows(IllegalStateException.class, () -> new RenderJob(everyShape(), numbers, W, H, 1).refined(2, false));
    }
    assertThrows(IllegalArgumentException.class, () -> one.refined(17, false));
  }

  @Test
  void thePictureIsThatOfTheSynthesis() {
    final SceneFile scene = everyShape();
    final Image image = new Image(W, H, scene.background());
    image.synthesis(scene.objects(), scene.camera(), RenderSettings.STANDARD.withShading(Shading.FACING));
    final RenderJob job = done(scene, RenderPass.COLOUR);
    for (int y = 0; y < H; y++) {
      for (int x = 0; x < W; x++) {
        assertEquals(image.getRGB(x, y), job.image().getRGB(x, y));
      }
    }
    assertEquals(1, job.share());
    assertEquals(0, job.secondsLeft());
    assertTrue(job.raysPerSecond() > 0);
  }

  @Test
  void aJobThatIsCancelledEndsEarly() {
    final RenderJob job = new RenderJob(everyShape(), RenderPass.COLOUR, 640, 480, 1);
    final AtomicInteger tiles = new AtomicInteger();
    assertFalse(job.run((x, y, width, height) -> {
      if (tiles.incrementAndGet() == 3) {
        job.cancel();
      }
      return true;
    }));
    assertEquals(3, tiles.get());
    assertTrue(job.share() > 0 && job.share() < 0.02);
  }

  @Test
  void tilesComeFromTheCentreOutwards() {
    final RenderJob job = new RenderJob(everyShape(), RenderPass.COLOUR, 640, 480, 1);
    final double[] last = {0};
    job.run((x, y, width, height) -> {
      final double distance = Math.hypot(x + width / 2.0 - 320, y + height / 2.0 - 240);
      assertTrue(distance > last[0] - RayTile.SIZE - 1, "(" + x + ", " + y + ")");
      last[0] = Math.max(last[0], distance);
      return true;
    });
  }

  @Test
  void theViewsShowNormalDepthAndCostOfEachRay() {
    final SceneFile scene = everyShape();
    final Image normals = done(scene, RenderPass.NORMALS).image();
    final RenderJob depth = done(scene, RenderPass.DEPTH), cost = done(scene, RenderPass.COST);
    final ColourScale near = depth.scale().orElseThrow(), tests = cost.scale().orElseThrow();
    final RayGenerator rays = scene.camera().getRayGenerator(W, H);
    for (int m = 0; m < W; m++) {
      for (int n = 0; n < H; n++) {
        final Hit hit = scene.objects().intersectionWith(rays.getRay(m, n));
        final int y = H - 1 - n;
        assertEquals(hit.hits() ? near.argb(hit.getT()) : 0, depth.image().getRGB(m, y));
        assertEquals(tests.argb(Cost.of(scene.objects(), rays.getRay(m, n))), cost.image().getRGB(m, y));
        final int red = hit.hits() ? (int) (127.5 * (1 + hit.normalX()) + 0.5) : 0;
        assertEquals(red, normals.getRGB(m, y) >> 16 & 0xff, 1);
      }
    }
  }

  @Test
  void aPictureOfNumbersThatIsCancelledHasOneScale() {
    final RenderJob job = new RenderJob(everyShape(), RenderPass.DEPTH, 320, 240, 1);
    final AtomicInteger tiles = new AtomicInteger();
    job.image().setRGB(0, 0, 0xff123456);
    assertFalse(job.run((x, y, width, height) -> tiles.incrementAndGet() < 60));
    assertEquals(0xff123456, job.image().getRGB(0, 0), "what is not rendered stays as it was");
    job.image().setRGB(0, 0, 0);
    final ColourScale scale = job.scale().orElseThrow();
    final RayGenerator rays = everyShape().camera().getRayGenerator(320, 240);
    int shown = 0;
    for (int i = 0; i < 320 * 240; i++) {
      final int argb = job.image().getRGB(i % 320, i / 320);
      if (argb != 0) {
        shown++;
        final Hit hit = everyShape().objects().intersectionWith(rays.getRay(i % 320, 239 - i / 320));
        assertEquals(scale.argb(hit.getT()), argb);
      }
    }
    assertTrue(shown > 1000, "only " + shown);
  }

  @Test
  void eachObjectHasAColourOfItsOwn() {
    final Object3D[] objects = new Object3D[12];
    for (int i = 0; i < objects.length; i++) {
      objects[i] = new Sphere(new Point3D(i % 4 - 1.5f, i / 4 - 1, 0), 0.45f, Color.RED);
    }
    final Image image = done(SampleScenes.of(new Orthographic(3.5f, 0.8f), true, objects), RenderPass.OBJECT).image();
    final Set<Integer> colours = new HashSet<>();
    for (final int argb : image.getRGB(0, 0, W, H, null, 0, W)) {
      colours.add(argb);
    }
    assertEquals(1 + objects.length, colours.size());
  }

  /** A student's shape: a disc with the required method only. */
  private static final class Disc extends Object3D {

    Disc() {
      super(Color.GREEN);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      final float t = -ray.getStartingPoint().z / ray.getDirection().z;
      if (!(t > 0) || ray.pointAtParameter(t).distance(new Point3D()) > 1) {
        return Hit.NOHIT;
      }
      return new Hit(t, ray.pointAtParameter(t), new Vector3D(0, 0, 1), this);
    }
  }

  @Test
  void allViewsShowAShapeOfOnesOwn() {
    for (final RenderPass view : RenderPass.values()) {
      final Image image = done(SampleScenes.of(new Orthographic(4, 0.8f), true, new Disc()), view).image();
      assertEquals(0xff, image.getRGB(W / 2, H / 2) >>> 24, view.name());
      assertTrue(view == RenderPass.COST || image.getRGB(W / 2, H / 2) != image.getRGB(1, 1), view.name());
    }
  }

  @Test
  void anEmptySceneHasNoDepth() {
    assertEquals(Optional.empty(), done(SampleScenes.of(new Orthographic(4, 0.8f), true), RenderPass.DEPTH).scale());
  }

  @Test
  void theScalesGoFromEndToEnd() {
    final ColourScale depth = ColourScale.ofDepth(2, 100), cost = ColourScale.ofCost(50);
    assertEquals(0xffffffff, depth.argb(2));
    assertEquals(0xff000000, depth.argb(100));
    assertEquals(0xff000000, cost.argb(0));
    assertEquals(0xffffffff, cost.argb(50));
    for (double position = 0; position <= 1; position += 0.125) {
      assertEquals(position, depth.position(depth.value(position)), 1e-12);
      assertEquals(position, cost.position(cost.value(position)), 1e-12);
    }
    assertEquals(0, ColourScale.ofDepth(3, 3).position(3));
  }

  @Test
  void viewsAreKnownByTheirNames() {
    for (final RenderPass view : RenderPass.values()) {
      assertEquals(Optional.of(view), RenderPass.named(view.option()));
    }
    assertEquals(Optional.of(RenderPass.DEPTH), RenderPass.named("Depth"));
    assertEquals(Optional.empty(), RenderPass.named("deep"));
  }
}
