package tracer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.Arrays;
import java.util.Random;

import javax.vecmath.TexCoord2f;

import org.junit.jupiter.api.Test;

import models.Sphere;
import primitives.Point3D;
import primitives.Vector3D;
import trials.Trials;

class HitTest {

  private static final Sphere BALL = new Sphere(new Point3D(), 1, Color.RED);
  private static final Hit HIT = new Hit(2, new Point3D(1, 2, 3), new Vector3D(0, 3, 4), BALL);

  @Test
  void accessorsAnswerWhatWasGivenWithAUnitNormal() {
    assertTrue(HIT.hits());
    assertEquals(2, HIT.getT());
    assertEquals(new Point3D(1, 2, 3), HIT.getPoint());
    assertEquals(new Vector3D(0, 0.6f, 0.8f), HIT.getNormal());
    assertSame(BALL, HIT.getObject());
    assertEquals("1.0 2.0 3.0 0.0 0.6 0.8", HIT.pointX() + " " + HIT.pointY() + " " + HIT.pointZ() + " "
        + HIT.normalX() + " " + HIT.normalY() + " " + HIT.normalZ());
  }

  @Test
  void absentHitIsInfinitelyFarAndHasNothing() {
    assertFalse(Hit.NOHIT.hits());
    assertEquals(Float.POSITIVE_INFINITY, Hit.NOHIT.getT());
    assertNull(Hit.NOHIT.getPoint());
    assertNull(Hit.NOHIT.getNormal());
    assertNull(Hit.NOHIT.getObject());
    assertTrue(Double.isNaN(Hit.NOHIT.pointX()) && Double.isNaN(Hit.NOHIT.normalZ()));
    assertEquals("Hit.NOHIT", Hit.NOHIT.toString());
  }

  @Test
  void closerIsLessFarStrictly() {
    final Hit farther = new Hit(Math.nextUp(2f), new Point3D(), new Vector3D(1, 0, 0), BALL);
    assertTrue(HIT.isCloser(farther));
    assertFalse(farther.isCloser(HIT));
    assertFalse(HIT.isCloser(HIT));
    assertTrue(HIT.isCloser(Hit.NOHIT));
    assertFalse(Hit.NOHIT.isCloser(HIT));
    assertFalse(Hit.NOHIT.isCloser(Hit.NOHIT));
  }

  @Test
  void neitherArgumentsNorAnswersChangeIt() {
    final Point3D P = new Point3D(1, 2, 3);
    final Vector3D n = new Vector3D(0, 3, 4);
    final Hit hit = new Hit(2, P, n, BALL);
    assertEquals(new Vector3D(0, 3, 4), n);
    P.set(9, 9, 9);
    n.set(1, 0, 0);
    hit.getPoint().set(9, 9, 9);
    hit.getNormal().set(9, 9, 9);
    assertEquals(HIT.toString(), hit.toString());
  }

  @Test
  void normalsOfAnyLengthAreBroughtToUnitLength() {
    for (final float k : new float[] {Float.MIN_VALUE, 1e-30f, 1e30f, Float.MAX_VALUE}) {
      assertEquals(new Vector3D(-1, 0, 0), new Hit(1, new Point3D(), new Vector3D(-k, 0, 0), BALL).getNormal());
      assertEquals(new Vector3D(0, 1, 0), new Hit(1, new Point3D(), new Vector3D(0, k, 0), BALL).getNormal());
      assertEquals(new Vector3D(0, 0, -1), new Hit(1, new Point3D(), new Vector3D(0, 0, -k), BALL).getNormal());
    }
  }

  @Test
  void normalIsTheGivenVectorByItsLength() {
    Trials.of(500, random -> {
      final double k = Math.pow(10, 8 * random.nextDouble() - 4);
      final double x = k * random.nextGaussian(), y = k * random.nextGaussian(), z = k * random.nextGaussian();
      final double length = Math.sqrt(x * x + y * y + z * z);
      final Hit hit = Hit.of(1, 0, 0, 0, x, y, z, BALL);
      assertEquals(x / length, hit.normalX(), 1e-15);
      assertEquals(y / length, hit.normalY(), 1e-15);
      assertEquals(z / length, hit.normalZ(), 1e-15);
      assertEquals(hit.normalX() + " " + hit.normalY() + " " + hit.normalZ(),
          hit.geometricX() + " " + hit.geometricY() + " " + hit.geometricZ());
    });
  }

  /** A short normal is not a zero normal, even if its squares underflow. */
  @Test
  void everyNormalButZeroMakesAHit() {
    for (final double[] n : new double[][] {{3, 4, 5}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {3, 5, 4}, {5, 3, 4}}) {
      assertTrue(Hit.of(1, 0, 0, 0, n[0], n[1], n[2], BALL).hits());
    }
  }

  @Test
  void computedHitThatIsNoneIsTheAbsentOne() {
    assertTrue(Hit.of(1, 2, 3, 4, 0, 0, 5, BALL).hits());
    for (final double t : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY, 1e39, 1e-50}) {
      assertSame(Hit.NOHIT, Hit.of(t, 2, 3, 4, 0, 0, 5, BALL), () -> "t = " + t);
    }
    for (int i = 0; i < 6; i++) {
      final double[] x = {2, 3, 4, 0, 0, 5};
      x[i] = Double.NaN;
      assertSame(Hit.NOHIT, Hit.of(1, x[0], x[1], x[2], x[3], x[4], x[5], BALL));
      x[i] = Double.POSITIVE_INFINITY;
      assertSame(Hit.NOHIT, Hit.of(1, x[0], x[1], x[2], x[3], x[4], x[5], BALL));
    }
    assertSame(Hit.NOHIT, Hit.of(1, 1e39, 0, 0, 0, 0, 1, BALL));
    assertSame(Hit.NOHIT, Hit.of(1, 2, 3, 4, 0, -0.0, 0, BALL));
  }

  @Test
  void normalThatShadesIsCutToTheFront() {
    final Vector3D g = new Vector3D(0, 0, 2);
    final Hit bent = new Hit(1, new Point3D(), new Vector3D(0, 3, 4), g, new TexCoord2f(0.25f, 7), BALL);
    assertEquals(new Vector3D(0, 0.6f, 0.8f), bent.getNormal());
    assertEquals(new Vector3D(0, 0, 1), bent.getGeometricNormal());
    assertEquals(new TexCoord2f(0.25f, 7), bent.getTexCoord());
    final Hit cut = new Hit(1, new Point3D(), new Vector3D(0, 3, -4), g, null, BALL);
    assertEquals(new Vector3D(0, 1, 0), cut.getNormal());
    assertNull(cut.getTexCoord());
    assertEquals(new Vector3D(0, 0, 1), new Hit(1, new Point3D(), new Vector3D(0, 0, -4), g, null, BALL).getNormal());
    assertEquals(HIT.getNormal(), HIT.getGeometricNormal());
    assertNull(HIT.getTexCoord());
    assertNull(Hit.NOHIT.getGeometricNormal());
    for (final TexCoord2f uv : new TexCoord2f[] {new TexCoord2f(Float.NaN, 0), new TexCoord2f(0, Float.NEGATIVE_INFINITY)}) {
      assertThrows(IllegalArgumentException.class, () -> new Hit(1, new Point3D(), g, g, uv, BALL));
    }
    assertThrows(IllegalArgumentException.class, () -> new Hit(1, new Point3D(), g, new Vector3D(), null, BALL));
  }

  /** The formula of the cut, n − min(0, n·g) g brought to unit length, for normals and geometric normals of any length. */
  @Test
  void cutNormalIsTheFormulaOfTheCut() {
    Trials.of(2000, random -> {
      final double[] g = vector(random), n = vector(random);
      final Hit hit = Hit.of(1, 0, 0, 0, g[0], g[1], g[2], BALL).withShading(n[0], n[1], n[2], 0.25, 0.75);
      final double[] unitG = unit(g), cut = unit(n);
      final double behind = Math.min(0, cut[0] * unitG[0] + cut[1] * unitG[1] + cut[2] * unitG[2]);
      for (int i = 0; i < 3; i++) {
        cut[i] -= behind * unitG[i];
      }
      assertArrayEquals(unit(cut), new double[] {hit.normalX(), hit.normalY(), hit.normalZ()}, 1e-10);
      assertArrayEquals(unitG, new double[] {hit.geometricX(), hit.geometricY(), hit.geometricZ()}, 1e-15);
      assertEquals("0.25 0.75", hit.textureU() + " " + hit.textureV());
    });
  }

  /** Where rounding alone decides whether a normal is cut, it is the same as far as rounding goes. */
  @Test
  void normalAtRightAnglesIsKept() {
    Trials.of(2000, random -> {
      final double[] g = vector(random), n = vector(random), unitG = unit(g);
      for (int pass = 0; pass < 2; pass++) {
        final double along = n[0] * unitG[0] + n[1] * unitG[1] + n[2] * unitG[2];
        for (int i = 0; i < 3; i++) {
          n[i] -= along * unitG[i];
        }
      }
      final Hit hit = shaded(g, n, Double.NaN, Double.NaN);
      assertArrayEquals(unit(n), new double[] {hit.normalX(), hit.normalY(), hit.normalZ()}, 1e-10);
    });
  }

  /** Where both normals are one vector the hit is that of the object that is not smooth, without a rounding between them. */
  @Test
  void normalThatShadesAsTheSurfaceIsTheGeometricOneBitForBit() {
    Trials.of(2000, random -> {
      final double[] g = vector(random);
      final Hit flat = Hit.of(1, 0, 0, 0, g[0], g[1], g[2], BALL);
      final String geometric = flat.normalX() + " " + flat.normalY() + " " + flat.normalZ();
      final Hit smooth = shaded(g, g, Double.NaN, Double.NaN);
      assertEquals(geometric, smooth.normalX() + " " + smooth.normalY() + " " + smooth.normalZ());
      assertEquals(geometric, smooth.geometricX() + " " + smooth.geometricY() + " " + smooth.geometricZ());
    });
  }

  @Test
  void normalThatDiffersInOneComponentOnlyIsKept() {
    final double[] g = {2.0 / 3, 2.0 / 3, 1.0 / 3};
    for (int i = 0; i < 3; i++) {
      for (final int length : new int[] {1, 3}) {
        final double[] n = {length * g[0], length * g[1], length * g[2]};
        n[i] = -n[i];
        final Hit hit = shaded(g, n, Double.NaN, Double.NaN);
        assertArrayEquals(unit(n), new double[] {hit.normalX(), hit.normalY(), hit.normalZ()}, 1e-15);
      }
    }
  }

  /** A hit with a geometric normal and one that shades, of any length. */
  private static Hit shaded(final double[] g, final double[] n, final double u, final double v) {
    return Hit.shaded(1, 0, 0, 0, g[0], g[1], g[2], Double.POSITIVE_INFINITY, BALL, n[0], n[1], n[2], u, v);
  }

  private static double[] vector(final Random random) {
    final double k = Math.pow(10, 6 * random.nextDouble() - 3);
    return new double[] {k * random.nextGaussian(), k * random.nextGaussian(), k * random.nextGaussian()};
  }

  private static double[] unit(final double[] v) {
    final double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return new double[] {v[0] / length, v[1] / length, v[2] / length};
  }

  @Test
  void theGeometricNormalShadesWhereTheGivenOneIsNoDirection() {
    final double inf = Double.POSITIVE_INFINITY;
    final double[][] normals = {{0, 0, 0}, {inf, 0, 1}, {0, -inf, 1}, {0, 0, inf}, {0, 0, Double.NaN}, {1e200, 0, 1}};
    for (final double[] n : normals) {
      final Hit hit = Hit.shaded(1, 0, 0, 0, 0, 0, 2, 0, BALL, n[0], n[1], n[2], 0.25, 0.75);
      assertEquals(new Vector3D(0, 0, 1), hit.getNormal(), () -> Arrays.toString(n));
    }
  }

  @Test
  void absentHitStaysAbsent() {
    assertSame(Hit.NOHIT, Hit.NOHIT.withShading(0, 0, 1, 0, 0));
    assertSame(Hit.NOHIT, Hit.shaded(0, 0, 0, 0, 0, 0, 1, 0, BALL, 0, 0, 1, 0, 0));
    assertSame(Hit.NOHIT, Hit.shaded(1, 1e40, 0, 0, 0, 0, 1, 0, BALL, 0, 0, 1, 0, 0));
    assertSame(Hit.NOHIT, Hit.shaded(1, 0, 0, 0, 0, 0, 0, 0, BALL, 0, 0, 1, 0, 0));
    assertSame(Hit.NOHIT, Hit.NOHIT.seenFromBehind(3));
  }

  @Test
  void hitSeenFromFartherBackIsThatMuchFarther() {
    final Hit hit = Hit.shaded(5, 1, 2, 3, 0, 3, 4, 1e-9, BALL, 0, 0, 1, 0.25, 0.5), back = hit.seenFromBehind(2.5);
    assertEquals(7.5, back.distance());
    assertEquals(7.5f, back.getT());
    assertEquals(hit.toString().replace("t=5.0", "t=7.5"), back.toString());
    assertEquals(hit.getGeometricNormal(), back.getGeometricNormal());
    assertEquals(hit.getTexCoord(), back.getTexCoord());
    assertEquals(1e-9, back.errorBound());
    assertSame(Hit.NOHIT, hit.seenFromBehind(Float.MAX_VALUE * 2.0));
    assertSame(Hit.NOHIT, hit.seenFromBehind(-6));
  }

  @Test
  void rayLeavesASlantingSurfaceAlongItsGeometricNormal() {
    Trials.of(200, random -> {
      final double[] g = unit(vector(random));
      final Hit hit = Hit.of(5, 1, 2, 3, g[0], g[1], g[2], 1e-7, BALL);
      for (final int side : new int[] {1, -1}) {
        final Ray ray = hit.leave(side > 0, 0, 0.6, 0.8);
        assertArrayEquals(new double[] {1 + side * 1e-7 * g[0], 2 + side * 1e-7 * g[1], 3 + side * 1e-7 * g[2]},
            new double[] {ray.startX(), ray.startY(), ray.startZ()}, 1e-15);
        assertEquals("0.0 0.6 0.8", ray.directionX() + " " + ray.directionY() + " " + ray.directionZ());
      }
    });
  }

  /** The largest number of a hit, which says how far off rays start at most, is a coordinate of either sign or t. */
  @Test
  void rayStartsAtMostAMillionthOfTheLargestNumberOffTheSurface() {
    for (final double[] x : new double[][] {{7, 1, 2, 3}, {1, 7, 2, 3}, {1, -7, 2, 3}, {1, 2, 7, 3}, {1, 2, -7, 3},
        {1, 2, 3, 7}, {1, 2, 3, -7}}) {
      assertEquals(7e-6, Hit.of(x[0], x[1], x[2], x[3], 0, 0, 1, 1, BALL).offset(), 1e-20);
    }
    assertEquals(1e-8, Hit.of(7, 1, 2, 3, 0, 0, 1, 1e-8, BALL).offset());
  }

  @Test
  void rayLeavesAHitOffTheSurface() {
    final Hit exact = Hit.of(5, 1, 2, 3, 0, 0, 1, 1e-12, BALL);
    assertEquals(3 + 1e-12, exact.leave(true, 1, 0, 0).startZ());
    assertEquals(3 - 1e-12, exact.leave(false, 1, 0, 0).startZ());
    assertFalse(exact.leave(true, 1, 0, 0).isBlindTo(exact));
    final Ray ray = new Hit(5, new Point3D(1, 2, 3), new Vector3D(0, 0, 1), BALL).leave(true, 1, 0, 0);
    assertEquals(3 + 5e-6, ray.startZ(), 1e-12);
    assertTrue(ray.isBlindTo(Hit.of(4.9e-4, 1, 2, 3, 0, 0, 1, BALL)));
    assertFalse(ray.isBlindTo(Hit.of(5.1e-4, 1, 2, 3, 0, 0, 1, BALL)));
    assertFalse(ray.isBlindTo(Hit.of(4e-4, 1, 2, 3, 0, 0, 1, new Sphere(new Point3D(), 1, Color.RED))));
  }

  @Test
  void textTellsEverything() {
    assertEquals("Hit(t=2.0, P=(1.0, 2.0, 3.0), n=(0.0, 0.6, 0.8), " + BALL + ")", HIT.toString());
  }
}
