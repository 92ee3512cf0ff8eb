package models;

import static models.HitAssertions.assertClose;
import static models.HitAssertions.assertMiss;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;

import javax.vecmath.AxisAngle4d;
import javax.vecmath.Matrix3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

class AffineTransformationTest implements Object3DContract {

  private static final Sphere UNIT = new Sphere(new Point3D(), 1, Color.RED);
  private static final Vector3f UP = new Vector3f(0, 0, 5);
  private static final Vector3f TWICE = new Vector3f(2, 2, 2);
  private static final Vector3f EAST = new Vector3f(10, 0, 0);

  /** A mirrored and stretched ball: half axes 2, 1 and 0.5, the first turned by 30° about z. */
  @Override
  public Object3D shape(final RandomPlacement at) {
    final Object3D stretched = new AffineTransformation(new Vector3f(-2, 1, 0.5f), new Vector3f(0, 0, 1), 30,
        new Vector3f(1, -1, 0.25f), UNIT);
    return at.transformed(stretched);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double c = Math.sqrt(0.75), px = x - 1, py = y + 1, a = (c * px + 0.5 * py) / 2, b = c * py - 0.5 * px,
        e = 2 * (z - 0.25);
    final double k = Math.sqrt(a * a + b * b + e * e), g = Math.sqrt(a * a / 4 + b * b + 4 * e * e);
    return k < 0.01 ? -0.5 : k * (k - 1) / g;
  }

  @Override
  public double accuracy() {
    return 1e-12;
  }

  private static void assertHit(final double t, final Point3D P, final Vector3D n, final Object3D transformed,
      final Ray ray) {
    final Hit hit = transformed.intersectionWith(ray);
    final String what = transformed + ", " + ray + ": " + hit;
    assertEquals(t, hit.getT(), 1e-6 * t, what);
    assertClose(P, hit.getPoint(), 1e-5, what);
    assertClose(n, hit.getNormal(), 1e-6, what);
    assertSame(UNIT, hit.getObject(), what);
  }

  @Test
  void eachOfTheSixConstructorsDoesWhatItSays() {
    final Ray ray = new Ray(new Point3D(10, 0, 30), new Vector3D(0, 0, -1));
    final Sphere aside = new Sphere(new Point3D(0, -10, 0), 1, Color.RED);
    assertEquals(28, new AffineTransformation(TWICE, UP, 90, EAST, UNIT).intersectionWith(ray).getT(), 1e-5);
    assertEquals(28, new AffineTransformation(TWICE, EAST, UNIT).intersectionWith(ray).getT(), 1e-5);
    assertEquals(29, new AffineTransformation(UP, 90, EAST, UNIT).intersectionWith(ray).getT(), 1e-5);
    assertEquals(29, new AffineTransformation(UP, 90, aside).intersectionWith(ray).getT(), 1e-5);
    assertEquals(28, new AffineTransformation(TWICE, UP, 90, new Sphere(new Point3D(0, -5, 0), 1, Color.RED))
        .intersectionWith(ray).getT(), 1e-5);
    assertEquals(28, new AffineTransformation(TWICE, new Sphere(new Point3D(5, 0, 0), 1,
        Color.RED)).intersectionWith(ray).getT(), 1e-5);
  }

  @Test
  void rotationIsCounterClockwiseSeenFromTheTipInDegrees() {
    final Sphere onX = new Sphere(new Point3D(4, 0, 0), 1, Color.RED);
    final Object3D turned = new AffineTransformation(UP, 90, onX);
    assertTrue(turned.intersectionWith(new Ray(new Point3D(0, 4, 9), new Vector3D(0, 0, -1))).hits());
    assertMiss(turned, new Ray(new Point3D(0, -4, 9), new Vector3D(0, 0, -1)));
    final Object3D third = new AffineTransformation(new Vector3f(1, 1, 1), 120, onX);
    assertTrue(third.intersectionWith(new Ray(new Point3D(0, 4, 9), new Vector3D(0, 0, -1))).hits());
  }

  @Test
  void scaleComesFirstThenRotationThenTranslation() {
    final Sphere onX = new Sphere(new Point3D(1, 0, 0), 0.25f, Color.RED);
    final Object3D object = new AffineTransformation(new Vector3f(3, 1, 1), UP, 90, new Vector3f(0, 0, 7), onX);
    final Hit hit = object.intersectionWith(new Ray(new Point3D(0, 3, 20), new Vector3D(0, 0, -1)));
    assertClose(new Point3D(0, 3, 7.25f), hit.getPoint(), 1e-5, hit.toString());
  }

  @Test
  void stretchedBallHasTheNormalOfTheEllipsoidByTheInverseTranspose() {
    final Object3D ellipsoid = new AffineTransformation(new Vector3f(5, 10, 1), UNIT);
    final Vector3D n = new Vector3D(0.6f / 5, 0, 0.8f);
    n.normalize();
    assertHit(7, new Point3D(3, 0, 0.8f), n, ellipsoid, new Ray(new Point3D(3, 0, 7.8f), new Vector3D(0, 0, -1)));
    assertHit(5, new Point3D(5, 0, 0), new Vector3D(1, 0, 0), ellipsoid,
        new Ray(new Point3D(10, 0, 0), new Vector3D(-1, 0, 0)));
  }

  @Test
  void mirroredObjectsKeepOutwardNormals() {
    final Object3D mirrored = new AffineTransformation(new Vector3f(-1, -1, -1),
        new Sphere(new Point3D(5, 0, 0), 1, Color.RED));
    final Hit hit = mirrored.intersectionWith(new Ray(new Point3D(-10, 0, 0), new Vector3D(1, 0, 0)));
    assertEquals(4, hit.getT(), 1e-6);
    assertClose(new Vector3D(-1, 0, 0), hit.getNormal(), 1e-6, hit.toString());
  }

  @Test
  void rayFromInsideHitsTheFarWallAtItsDistanceInTheScene() {
    final Object3D object = new AffineTransformation(new Vector3f(4, 4, 4), EAST, UNIT);
    assertHit(4, new Point3D(14, 0, 0), new Vector3D(1, 0, 0), object,
        new Ray(new Point3D(10, 0, 0), new Vector3D(1, 0, 0)));
    assertMiss(object, new Ray(new Point3D(15, 0, 0), new Vector3D(1, 0, 0)));
  }

  @Test
  void colourIsThatOfTheObject() {
    assertEquals(Color.RED, new AffineTransformation(TWICE, UNIT).getColor());
    assertNull(new AffineTransformation(TWICE, new Group3D()).getColor());
  }

  @Test
  void argumentsCanBeChangedAfterwards() {
    final Vector3f s = new Vector3f(2, 2, 2), axis = new Vector3f(0, 0, 1), d = new Vector3f(1, 0, 0);
    final Object3D object = new AffineTransformation(s, axis, 45, d, UNIT);
    s.set(9, 9, 9);
    axis.set(1, 0, 0);
    d.set(-50, 0, 0);
    assertHit(7, new Point3D(3, 0, 0), new Vector3D(1, 0, 0), object,
        new Ray(new Point3D(10, 0, 0), new Vector3D(-1, 0, 0)));
    assertEquals(new Vector3f(9, 9, 9), s);
  }

  @Test
  void axesAreNotNormalisedInPlace() {
    final Vector3f axis = new Vector3f(0, 0, 5);
    new AffineTransformation(axis, 30, UNIT);
    assertEquals(new Vector3f(0, 0, 5), axis);
  }

  @Test
  void boxOfATurnedBoxHoldsIt() {
    final Object3D turned = new AffineTransformation(new Vector3f(1, 1, 1), UP, 45, new Vector3f(100, 0, 0),
        new Box(new Point3D(), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), 2, 2, 2, Color.RED));
    assertEquals(100 + Math.sqrt(2), turned.getBoundingBox().maxX(), 1e-4);
    assertEquals(1, turned.getBoundingBox().maxZ(), 1e-5);
  }

  /** The box is the least about the eight transformed corners, which are computed here one by one from T · R · S. */
  @Test
  void theBoxIsTheLeastAboutTheEightCorners() {
    for (final float theta : new float[] {37, -37, 120, 200}) {
      final Vector3f s = new Vector3f(2, -3, 5), d = new Vector3f(-70, 110, 13);
      theBoxIsTheLeastAboutTheEightCorners(s, new Vector3f(1, 2, -4), theta, d);
      theBoxIsTheLeastAboutTheEightCorners(s, new Vector3f(3, 2, 1), theta, d);
    }
  }

  private static void theBoxIsTheLeastAboutTheEightCorners(final Vector3f s, final Vector3f axis, final float theta,
      final Vector3f d) {
    final double[] half = {1, 1.5, 2}, centre = {7, -5, 3};
    final Object3D box = new Box(new Point3D(7, -5, 3), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), 2, 3, 4, Color.RED);
    final Matrix3d rotation = new Matrix3d();
    final Vector3d unit = new Vector3d(axis);
    unit.normalize();
    rotation.set(new AxisAngle4d(unit, Math.toRadians(theta)));
    final double[] least = {1e9, 1e9, 1e9}, most = {-1e9, -1e9, -1e9};
    for (int corner = 0; corner < 8; corner++) {
      final Vector3d P = new Vector3d(s.x * (centre[0] + half[0] * (corner % 2 * 2 - 1)),
          s.y * (centre[1] + half[1] * (corner / 2 % 2 * 2 - 1)), s.z * (centre[2] + half[2] * (corner / 4 * 2 - 1)));
      rotation.transform(P);
      P.add(new Vector3d(d));
      final double[] p = {P.x, P.y, P.z};
      for (int i = 0; i < 3; i++) {
        least[i] = Math.min(least[i], p[i]);
        most[i] = Math.max(most[i], p[i]);
      }
    }
    final BoundingBox found = new AffineTransformation(s, axis, theta, d, box).getBoundingBox();
    final float[] min = {found.minX(), found.minY(), found.minZ()}, max = {found.maxX(), found.maxY(), found.maxZ()};
    for (int i = 0; i < 3; i++) {
      assertTrue(min[i] <= least[i] && max[i] >= most[i], found::toString);
      assertEquals(least[i], min[i], 3e-5, found::toString);
      assertEquals(most[i], max[i], 3e-5, found::toString);
    }
  }

  @Test
  void boxOfAPlaneOrAnEmptyGroupStaysAsItIs() {
    assertTrue(new AffineTransformation(TWICE, new Group3D()).getBoundingBox().isEmpty());
    assertEquals("BoundingBox((-Infinity, -Infinity, -Infinity), (Infinity, Infinity, Infinity))", new AffineTransformation(
        TWICE, new Plane(new Point3D(), new Vector3D(0, 0, 1), Color.RED)).getBoundingBox().toString());
  }

  @Test
  void transformationsWithinEachOtherAreOneAfterTheOther() {
    Object3D object = UNIT;
    for (int i = 0; i < 100; i++) {
      object = new AffineTransformation(new Vector3f(1, 1, 1), UP, 3.6f, new Vector3f(0, 0, 1), object);
    }
    assertHit(9, new Point3D(0, 0, 101), new Vector3D(0, 0, 1), object,
        new Ray(new Point3D(0, 0, 110), new Vector3D(0, 0, -1)));
  }

  @Test
  void twoHundredTransformationsWithinEachOtherAreNotTooMany() {
    Object3D object = UNIT;
    for (int i = 0; i < 200; i++) {
      final Group3D group = new Group3D();
      group.addObject(new AffineTransformation(new Vector3f(1, 1, 1), new Vector3f(0, 0, i % 2 == 0 ? 1 : -1), object));
      object = group;
    }
    assertEquals(9, object.intersectionWith(new Ray(new Point3D(0, 0, 10), new Vector3D(0, 0, -1))).getT(), 1e-5);
  }

  @Test
  void textTellsTheObject() {
    assertEquals("AffineTransformation(" + UNIT + ")", new AffineTransformation(TWICE, UNIT).toString());
  }
}
