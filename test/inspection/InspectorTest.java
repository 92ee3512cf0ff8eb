package inspection;

import static arguments.Arguments.notNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Function;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import models.AffineTransformation;
import models.SphereTrace;
import models.Object3D;
import models.Sphere;
import models.Torus;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import view.FishEye;
import scenes.SceneFile;
import scenes.SceneReader;
import tracer.Hit;
import tracer.Ray;
import rendering.Progress;
import upnatray.RenderJob;
import rendering.RenderPass;
import view.Angular;
import view.Orthographic;
import view.Projection;

class InspectorTest {

  private static final int W = 48;
  private static final int H = 36;

  private static Inspection centre(final Object3D... objects) {
    return new Inspector(SampleScenes.of(new Orthographic(4, 1), true, objects), 5, 5).inspect(2, 2);
  }

  @Test
  void theColourOfEveryPixelIsThatOfThePicture() {
    for (final Projection projection : List.of(SampleScenes.perspective(), new Orthographic(4, 0.75f), new Angular(50))) {
      for (final boolean facing : new boolean[] {true, false}) {
        final SceneFile scene = SampleScenes.of(projection, facing, SampleScenes.everyShape());
        final RenderJob job = new RenderJob(scene, RenderPass.COLOUR, W, H, 2);
        assertTrue(job.run(Progress.NONE));
        final Inspector inspector = new Inspector(scene, W, H);
        for (int m = 0; m < W; m++) {
          for (int n = 0; n < H; n++) {
            final Inspection inspection = inspector.inspect(m, n);
            assertEquals(job.image().getRGB(m, H - 1 - n), inspection.argb(), "(" + m + ", " + n + ")");
            inspection.intersections().forEach(found -> assertEquals(List.of(), found.violations(), found.toString()));
          }
        }
      }
    }
  }

  @Test
  void intersectionsAreSortedAlongTheRayAndNamed() {
    final Sphere near = new Sphere(new Point3D(0, 0, 2), 0.5f, Color.RED), far = new Sphere(new Point3D(), 1, Color.BLUE);
    final Inspection inspection = centre(far, near, new Sphere(new Point3D(9, 9, 9), 1, Color.GREEN));
    assertEquals(2, inspection.intersections().size());
    final Intersection first = inspection.intersections().get(0), second = inspection.intersections().get(1);
    assertSame(near, first.object());
    assertTrue(first.winner());
    assertEquals("the Sphere", first.name());
    assertEquals(2.5f, first.hit().getT(), 1e-6f);
    assertSame(far, second.object());
    assertFalse(second.winner());
    assertEquals(4, second.hit().getT(), 1e-6f);
    assertEquals(2, inspection.tests());
  }

  @Test
  void ofTwoAtTheSameDistanceTheFirstAddedWins() {
    final Sphere one = new Sphere(new Point3D(), 1, Color.RED), other = new Sphere(new Point3D(), 1, Color.BLUE);
    assertSame(one, centre(one, other).winner().orElseThrow().object());
    assertEquals(Color.RED.getRGB(), centre(one, other).colour().get(0).argb());
  }

  @Test
  void theFormulasHaveTheNumbersOfThePixel() {
    final Inspection inspection = new Inspector(SampleScenes.of(new Orthographic(4, 1), true), 8, 8).inspect(1, 6);
    final List<Formula> formulas = inspection.pixel().formulas();
    final Function<String, String> value = symbol -> formulas.stream().filter(f -> f.symbol().equals(symbol))
        .findFirst().orElseThrow().value();
    assertEquals("-1.25", value.apply("x"));
    assertEquals("1.25", value.apply("y"));
    assertEquals("(-1.25, 1.25, 5)", value.apply("R"));
    assertEquals("(0, 0, -1)", value.apply("v"));
    assertEquals("(1 + 0.5) · 4 / 8 − 4 / 2", formulas.get(2).numbers());
  }

  @Test
  void theLastFormulasAreTheRay() {
    for (final Projection projection : List.of(SampleScenes.perspective(), new Angular(80))) {
      final PixelRay pixel = new Inspector(SampleScenes.of(projection, true), 30, 20).inspect(17, 4).pixel();
      final Vector3D v = pixel.ray().getDirection();
      final String[] numbers = pixel.formulas().get(pixel.formulas().size() - 1).value().replaceAll("[()]", "").split(", ");
      assertEquals(v.x, Float.parseFloat(numbers[0]), 1e-6f);
      assertEquals(v.y, Float.parseFloat(numbers[1]), 1e-6f);
      assertEquals(v.z, Float.parseFloat(numbers[2]), 1e-6f);
    }
  }

  @Test
  void theLastFormulasAreTheRayOfASceneFileToo() {
    final SceneFile scene = SceneReader.read(Path.of("scenes", "angular.xml")).scene().orElseThrow();
    for (final int[] at : new int[][] {{400, 400}, {100, 300}, {1, 399}}) {
      final PixelRay pixel = new Inspector(scene, 800, 800).inspect(at[0], at[1]).pixel();
      final Formula last = pixel.formulas().get(pixel.formulas().size() - 1);
      assertEquals("v", last.symbol());
      final String[] numbers = last.value().replaceAll("[()]", "").split(", ");
      final Vector3D given = pixel.ray().getDirection(), computed = new Vector3D(
          Float.parseFloat(numbers[0]), Float.parseFloat(numbers[1]), Float.parseFloat(numbers[2]));
      computed.sub(given);
      assertEquals(0, computed.length(), 1e-6f, pixel::toString);
    }
  }

  @Test
  void outsideTheCircleOfAFishEyeThereIsNoRay() {
    for (final Projection fishEye : List.of(new Angular(90), new FishEye(90), new FishEye(180))) {
      final Inspection corner = new Inspector(SampleScenes.of(fishEye, true), 30, 30).inspect(0, 0);
      assertSame(Ray.NORAY, corner.pixel().ray());
      assertEquals("NORAY", corner.pixel().formulas().get(corner.pixel().formulas().size() - 1).value());
      assertEquals(ColourStep.Kind.NO_RAY, corner.colour().get(0).kind());
      assertEquals(List.of(), corner.intersections());
    }
  }

  @Test
  void aTransformedObjectShowsRayAndHitInItsOwnFrame() {
    final Sphere unit = new Sphere(new Point3D(), 1, Color.RED);
    final Intersection intersection = centre(new AffineTransformation(new Vector3f(2, 2, 2), new Vector3f(0, 0, -1), unit))
        .intersections().get(0);
    assertSame(unit, intersection.object());
    assertNotSame(unit, intersection.sceneObject());
    assertEquals(4, intersection.hit().getT(), 1e-6f);
    final LocalRay frame = intersection.localRays().get(0);
    assertEquals(new Point3D(0, 0, 3), frame.ray().getStartingPoint());
    assertEquals(2, frame.hit().getT(), 1e-6f);
    assertEquals(new Point3D(0, 0, 1), frame.hit().getPoint());
  }

  @Test
  void aSphereTraceHasEachStep() {
    final Intersection intersection = centre(new Torus(new Point3D(), new Vector3D(0, 1, 0), 1, 0.4f,
        Color.RED)).intersections().get(0);
    final SphereTrace trace = intersection.trace().orElseThrow();
    assertEquals(SphereTrace.End.REACHED, trace.end());
    assertEquals(3.6, trace.t(), 1e-6);
    assertEquals(intersection.hit().getT(), trace.t(), 1e-6);
    assertEquals(0, trace.steps().get(0).t());
    assertEquals(3.6, trace.steps().get(0).distance(), 1e-6);
  }

  @Test
  void aSphereTraceThatMissesATorusIsReportedToo() {
    final Torus ring = new Torus(new Point3D(), new Vector3D(0, 0, 1), 1, 0.4f, Color.RED);
    final Torus far = new Torus(new Point3D(9, 9, 9), new Vector3D(0, 0, 1), 1, 0.4f, Color.RED);
    final Intersection intersection = centre(ring, far).intersections().get(0);
    assertSame(ring, intersection.object());
    assertFalse(intersection.hit().hits() || intersection.winner());
    assertEquals(SphereTrace.End.PASSED, intersection.trace().orElseThrow().end());
    assertEquals(1, centre(ring).intersections().size());
  }

  @Test
  void endlessRecursionOfAShapeIsReported() {
    final Intersection intersection = centre(new Wrong() {
      @Override
      public Hit intersectionWith(final Ray ray) {
        return intersectionWith(ray);
      }
    }).intersections().get(0);
    assertEquals(List.of(ContractViolation.EXCEPTION), intersection.violations());
    assertTrue(intersection.failure().contains("StackOverflowError"), intersection.failure());
  }

  /** A user-written shape with a bug. */
  private abstract static class Wrong extends Object3D {

    Wrong() {
      super(Color.RED);
    }

    static Hit right(final Wrong object) {
      return new Hit(4, new Point3D(0, 0, 1), new Vector3D(0, 0, 1), object);
    }
  }

  private static List<ContractViolation> violations(final Wrong object) {
    return centre(object).intersections().get(0).violations();
  }

  @Test
  void aNullHitIsReported() {
    assertEquals(List.of(ContractViolation.NULL_HIT), violations(new Wrong() {
      @Override
      public Hit intersectionWith(final Ray ray) {
        return null;
      }
    }));
  }

  @Test
  void anExceptionIsReportedWithItsMessage() {
    final Intersection intersection = centre(new Wrong() {
      @Override
      public Hit intersectionWith(final Ray ray) {
        throw new ArithmeticException("by zero");
      }
    }).intersections().get(0);
    assertEquals(List.of(ContractViolation.EXCEPTION), intersection.violations());
    assertTrue(intersection.failure().contains("by zero (InspectorTest.java:"), intersection.failure());
    assertFalse(intersection.winner());
  }

  /** The caller that passed the wrong value, not the method that noticed. */
  @Test
  void anExceptionIsLocatedOutsideTheJdkAndTheChecks() {
    for (final Runnable wrong : List.<Runnable>of(() -> Objects.requireNonNull(null), () -> new ArrayList<>().get(0),
        () -> Integer.parseInt(""), () -> notNull("this", null))) {
      final Intersection intersection = centre(new Wrong() {
        @Override
        public Hit intersectionWith(final Ray ray) {
          wrong.run();
          return Hit.NOHIT;
        }
      }).intersections().get(0);
      assertTrue(intersection.failure().matches("(?s).* \\(InspectorTest.java:\\d+\\)"), intersection.failure());
    }
  }

  @Test
  void aPointOffTheRayIsReported() {
    assertEquals(List.of(ContractViolation.POINT_OFF_RAY), violations(new Wrong() {
      @Override
      public Hit intersectionWith(final Ray ray) {
        return new Hit(3, new Point3D(0, 0, 1), new Vector3D(0, 0, 1), this);
      }
    }));
  }

  @Test
  void anInconsistentHitIsReported() {
    assertEquals(List.of(ContractViolation.INCONSISTENT), violations(new Wrong() {
      private boolean called;

      @Override
      public Hit intersectionWith(final Ray ray) {
        called = !called;
        return called ? right(this) : Hit.NOHIT;
      }
    }));
  }

  private static Wrong withBox(final BoundingBox box, final float normalZ) {
    return new Wrong() {
      @Override
      public Hit intersectionWith(final Ray ray) {
        return new Hit(4, new Point3D(0, 0, 1), new Vector3D(0, 0, normalZ), this);
      }

      @Override
      public BoundingBox getBoundingBox() {
        return box;
      }
    };
  }

  @Test
  void wrongBoxesAreReported() {
    assertEquals(List.of(ContractViolation.NULL_BOX), violations(withBox(null, 1)));
    assertEquals(List.of(ContractViolation.POINT_OUTSIDE_BOX),
        violations(withBox(new BoundingBox(new Point3D(-1, -1, -1), new Point3D(1, 1, 0.5f)), 1)));
    assertEquals(List.of(ContractViolation.BOX_MISSED_BY_RAY, ContractViolation.POINT_OUTSIDE_BOX),
        violations(withBox(new BoundingBox(new Point3D(2, 2, 2), new Point3D(3, 3, 3)), 1)));
  }

  /** As in the picture, where the group does not test it. */
  @Test
  void anObjectWithTooSmallABoxIsNotTheWinner() {
    final Inspection inspection = centre(withBox(new BoundingBox(new Point3D(2, 2, 2), new Point3D(3, 3, 3)), 1));
    assertFalse(inspection.intersections().get(0).winner());
    assertEquals(new Color(10, 20, 30).getRGB(), inspection.argb());
  }

  @Test
  void aNormalThatPointsInwardIsReported() {
    final BoundingBox box = new BoundingBox(new Point3D(-1, -1, -1), new Point3D(1, 1, 1));
    assertEquals(List.of(), violations(withBox(box, 1)));
    assertEquals(List.of(ContractViolation.NORMAL_INWARD), violations(withBox(box, -1)));
  }

  @Test
  void pixelsOutsideThePictureAreRejected() {
    final Inspector inspector = new Inspector(SampleScenes.of(new Orthographic(4, 1), true), 4, 3);
    assertThrows(IllegalArgumentException.class, () -> inspector.inspect(4, 0));
    assertThrows(IllegalArgumentException.class, () -> inspector.inspect(0, 3));
    assertThrows(IllegalArgumentException.class, () -> inspector.inspect(-1, 0));
  }
}
