package tracer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;

import javax.vecmath.TexCoord2f;

import org.junit.jupiter.api.Test;

import models.Sphere;
import primitives.Point3D;
import primitives.Vector3D;

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
