package tracer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;

import org.junit.jupiter.api.Test;

import models.Object3D;
import models.Sphere;
import primitives.Point3D;
import primitives.Vector3D;
import trials.Trials;

class RayTest {

  private static final Ray RAY = new Ray(new Point3D(1, 2, 3), new Vector3D(0, 30, -40));

  @Test
  void directionIsBroughtToUnitLengthSoThatTIsADistance() {
    assertEquals(new Vector3D(0, 0.6f, -0.8f), RAY.getDirection());
    assertEquals(new Point3D(1, 2, 3), RAY.getStartingPoint());
    assertTrue(new Point3D(1, 5, -1).epsilonEquals(RAY.pointAtParameter(5), 1e-6f));
    assertTrue(new Point3D(1, -1, 7).epsilonEquals(RAY.pointAtParameter(-5), 1e-6f));
    assertEquals(new Point3D(1, 2, 3), RAY.pointAtParameter(0));
  }

  @Test
  void rayThroughAPointPassesItAtItsDistance() {
    final Ray ray = new Ray(new Point3D(1, 2, 3), new Point3D(1, 32, -37));
    assertEquals(RAY.getDirection(), ray.getDirection());
    assertTrue(new Point3D(1, 32, -37).epsilonEquals(ray.pointAtParameter(50), 1e-5f));
  }

  @Test
  void directionsOfAnyLengthHaveADirection() {
    for (final float k : new float[] {Float.MIN_VALUE, 1e-38f, 1e-20f, 1, 1e20f, Float.MAX_VALUE}) {
      final Ray ray = new Ray(new Point3D(), new Vector3D(0, -k, 0));
      assertEquals(new Vector3D(0, -1, 0), ray.getDirection());
      final Ray diagonal = new Ray(new Point3D(), new Vector3D(k, k, 0));
      assertEquals(Math.sqrt(0.5), diagonal.directionX(), 1e-7);
    }
    final Ray across = new Ray(new Point3D(-Float.MAX_VALUE, 0, 0), new Point3D(Float.MAX_VALUE, 0, 0));
    assertEquals(new Vector3D(1, 0, 0), across.getDirection());
  }

  @Test
  void directionIsAUnitVectorAsFloatsAndAsDoubles() {
    Trials.of(2000, random -> {
      final Ray ray = new Ray(new Point3D(), new Vector3D(random.nextFloat() - 0.5f, random.nextFloat() - 0.5f,
          random.nextFloat() - 0.5f));
      final double x = ray.directionX(), y = ray.directionY(), z = ray.directionZ();
      assertEquals(1, Math.sqrt(x * x + y * y + z * z), 4e-16);
      assertEquals(1, ray.getDirection().length(), 1.2e-7);
      assertEquals(x, ray.getDirection().x, 1.2e-7);
      assertEquals(z, ray.getDirection().z, 1.2e-7);
    });
  }

  @Test
  void axisParallelDirectionsStayExact() {
    final Ray ray = new Ray(new Point3D(0.1f, 0.2f, 0.3f), new Vector3D(0, -0f, 7));
    assertEquals(1, ray.directionZ());
    assertTrue(ray.directionX() == 0 && ray.directionY() == 0);
  }

  @Test
  void neitherArgumentsNorAnswersChangeIt() {
    final Point3D R = new Point3D(1, 2, 3), Q = new Point3D(5, 6, 7);
    final Vector3D v = new Vector3D(0, 2, 0);
    final Ray one = new Ray(R, v), other = new Ray(R, Q);
    final String before = one + " " + other;
    assertEquals(new Vector3D(0, 2, 0), v);
    R.set(9, 9, 9);
    v.set(1, 0, 0);
    Q.set(0, 0, 0);
    one.getStartingPoint().set(9, 9, 9);
    one.getDirection().set(9, 9, 9);
    one.pointAtParameter(3).set(9, 9, 9);
    assertEquals(before, one + " " + other);
  }

  @Test
  void numbersInDoubleAreThoseOfTheFloats() {
    assertEquals("1.0 2.0 3.0", RAY.startX() + " " + RAY.startY() + " " + RAY.startZ());
    assertEquals(0.6f, RAY.directionY(), 1e-7);
  }

  @Test
  void raysOfGeneratorsAreRoundedLikeOthers() {
    final Ray ray = Ray.towards(0.1, 0.2, 0.3, 1, 2, 3);
    final Ray same = new Ray(new Point3D(0.1f, 0.2f, 0.3f), new Vector3D(1, 2, 3));
    assertEquals(same.toString(), ray.toString());
    assertEquals(same.directionX(), ray.directionX());
    final Vector3D v = same.getDirection();
    final Ray along = Ray.along(same.startX(), same.startY(), same.startZ(), v.x, v.y, v.z);
    assertEquals(same.directionX() + " " + same.directionY() + " " + same.directionZ(),
        along.directionX() + " " + along.directionY() + " " + along.directionZ());
    assertEquals(v, along.getDirection());
  }

  @Test
  void exactRaysKeepAllDigits() {
    final Ray ray = Ray.exactly(0.1, 0.2, 0.3, 0.6, 0, 0.8);
    assertEquals("0.1 0.2 0.3 0.6 0.0 0.8", ray.startX() + " " + ray.startY() + " " + ray.startZ() + " "
        + ray.directionX() + " " + ray.directionY() + " " + ray.directionZ());
    assertEquals(new Vector3D(0.6f, 0, 0.8f), ray.getDirection());
    assertEquals(new Point3D(0.1f, 0.2f, 0.3f), ray.getStartingPoint());
  }

  @Test
  void rayOfAGeneratorHasItsDirectionWhateverItsLength() {
    Trials.of(500, random -> {
      final double k = Math.pow(10, 8 * random.nextDouble() - 4);
      final double x = k * random.nextGaussian(), y = k * random.nextGaussian(), z = k * random.nextGaussian();
      final double length = Math.sqrt(x * x + y * y + z * z);
      final Ray ray = Ray.towards(1, 2, 3, x, y, z);
      assertEquals(x / length, ray.directionX(), 1e-7);
      assertEquals(y / length, ray.directionY(), 1e-7);
      assertEquals(z / length, ray.directionZ(), 1e-7);
    });
  }

  @Test
  void rayFromFartherOnIsTheSameLine() {
    final Ray ray = Ray.exactly(1, 2, 3, 2.0 / 3, -2.0 / 3, 1.0 / 3).from(6);
    assertEquals("5.0 -2.0 5.0", ray.startX() + " " + ray.startY() + " " + ray.startZ());
    assertEquals(2.0 / 3 + " " + -2.0 / 3 + " " + 1.0 / 3,
        ray.directionX() + " " + ray.directionY() + " " + ray.directionZ());
    assertEquals(0, ray.blindness());
  }

  @Test
  void pointsOfARayLieAlongItsDirection() {
    final Ray ray = Ray.exactly(1, 2, 3, 2.0 / 3, -2.0 / 3, 1.0 / 3);
    assertEquals(new Point3D(3, 0, 4), ray.pointAtParameter(3));
    assertEquals(new Point3D(-1, 4, 2), ray.pointAtParameter(-3));
  }

  /** In a frame where all lengths are four times as large, so is the distance within which a ray is blind. */
  @Test
  void blindnessIsALengthOfItsFrame() {
    final Object3D ball = new Sphere(new Point3D(), 1, Color.RED), other = new Sphere(new Point3D(), 1, Color.RED);
    final Ray ray = Ray.leaving(1, 2, 3, 0, 0, 1, ball, 0.5), there = ray.inFrame(4, 8, 12, 1, 0, 0, 4);
    assertEquals(0.5, ray.blindness());
    assertEquals(2, there.blindness());
    assertEquals("4.0 8.0 12.0 1.0 0.0 0.0", there.startX() + " " + there.startY() + " " + there.startZ() + " "
        + there.directionX() + " " + there.directionY() + " " + there.directionZ());
    assertTrue(there.isBlindTo(Hit.of(2, 0, 0, 0, 0, 0, 1, ball)));
    assertFalse(there.isBlindTo(Hit.of(Math.nextUp(2.0), 0, 0, 0, 0, 0, 1, ball)));
    assertFalse(there.isBlindTo(Hit.of(1, 0, 0, 0, 0, 0, 1, other)));
    assertFalse(Ray.exactly(0, 0, 0, 0, 0, 1).isBlindTo(Hit.NOHIT));
  }

  @Test
  void absentRayAnswersNullOrNaN() {
    assertNull(Ray.NORAY.getStartingPoint());
    assertNull(Ray.NORAY.getDirection());
    assertNull(Ray.NORAY.pointAtParameter(1));
    assertTrue(Double.isNaN(Ray.NORAY.startX() + Ray.NORAY.startY() + Ray.NORAY.startZ()));
    assertTrue(Double.isNaN(Ray.NORAY.directionX()) && Double.isNaN(Ray.NORAY.directionZ()));
    assertEquals("Ray.NORAY", Ray.NORAY.toString());
  }

  @Test
  void textTellsStartAndDirection() {
    assertEquals("Ray(R=(1.0, 2.0, 3.0), v=(0.0, 0.6, -0.8))", RAY.toString());
  }
}
