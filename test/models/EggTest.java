package models;

import static models.HitAssertions.assertHit;
import static models.HitAssertions.assertMiss;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;

class EggTest implements Object3DContract {

  private static final Point3D O = new Point3D();
  private static final Vector3D X = new Vector3D(1, 0, 0);
  private static final Vector3D Y = new Vector3D(0, 1, 0);

  /** q = b² + w² + 2 w y = 29 + 4 y: radius 15/√29 at y = 0, and 3, the largest, at y = −2. */
  private static final Egg EGG = new Egg(O, new Vector3D(0, 7, 0), 3, 5, 2, Color.RED);

  @Override
  public Object3D shape(final RandomPlacement at) {
    return new Egg(at.point(1, -2, 3), at.direction(1, 2, 2), at.length(1.5f), at.length(2), at.length(0.75f), Color.RED);
  }

  @Override
  public double signedDistance(final double x, final double y, final double z) {
    final double px = x - 1, py = y + 2, pz = z - 3, s = (px + 2 * py + 2 * pz) / 3;
    final double r2 = Math.max(0, px * px + py * py + pz * pz - s * s);
    if (Math.abs(s) > 2) {
      return Math.abs(s) - 2 + Math.sqrt(r2) * 0.5;
    }
    final double q = 4 + 0.5625 + 1.5 * s, f = r2 * q - 2.25 * (4 - s * s);
    return f / (2 * Math.hypot(Math.sqrt(r2) * q, 0.75 * r2 + 2.25 * s) + 1e-9);
  }

  @Override
  public double accuracy() {
    return 1e-7;
  }

  @Test
  void raysAlongTheAxisHitThePoles() {
    assertHit(5, new Point3D(0, 5, 0), Y, EGG, new Ray(new Point3D(0, 10, 0), new Vector3D(0, -1, 0)));
    assertHit(3, new Point3D(0, -5, 0), new Vector3D(0, -1, 0), EGG, new Ray(new Point3D(0, -8, 0), Y));
    assertHit(4, new Point3D(0, 5, 0), Y, EGG, new Ray(new Point3D(0, 1, 0), Y));
  }

  @Test
  void theLargestRadiusIsAtMinusW() {
    assertHit(7, new Point3D(-3, -2, 0), new Vector3D(-1, 0, 0), EGG, new Ray(new Point3D(-10, -2, 0), X));
    assertHit(3, new Point3D(3, -2, 0), X, EGG, new Ray(new Point3D(0, -2, 0), X));
    assertMiss(EGG, new Ray(new Point3D(-10, -2, Math.nextUp(3f)), X));
  }

  /** At y = 0: radius 15/√29, normal along (x q, w x²) = (15/√29 · 29, 2 · 225/29). */
  @Test
  void rayAcrossTheMiddleHitsWhereThePaperSays() {
    final double r = 15 / Math.sqrt(29), nx = r * 29, ny = 2 * r * r, n = Math.hypot(nx, ny);
    assertHit(10 - r, new Point3D((float) -r, 0, 0), new Vector3D((float) (-nx / n), (float) (ny / n), 0), EGG,
        new Ray(new Point3D(-10, 0, 0), X));
  }

  @Test
  void theOtherSheetIsNoPartOfIt() {
    for (float y = -7.25f; y > -40; y -= 0.5f) {
      assertMiss(EGG, new Ray(new Point3D(-1000, y, 0.5f), X));
      assertMiss(EGG, new Ray(new Point3D(3, y, 4), new Vector3D(0, -1, 0)));
    }
    final Hit down = EGG.intersectionWith(new Ray(O, new Vector3D(0.1f, -1, 0)));
    assertTrue(down.getT() < 6, down::toString);
    assertMiss(EGG, new Ray(new Point3D(0, -5.1f, 0), new Vector3D(0.3f, -1, 0)));
  }

  @Test
  void tangentRaysTouchAtOnePointIfAtAll() {
    final Hit side = EGG.intersectionWith(new Ray(new Point3D(3, -2, -9), new Vector3D(0, 0, 1)));
    assertTrue(!side.hits() || Math.abs(side.getT() - 9) < 1e-5, side.toString());
    final Hit pole = EGG.intersectionWith(new Ray(new Point3D(-9, 5, 0), X));
    assertTrue(!pole.hits() || Math.abs(pole.getT() - 9) < 1e-5, pole.toString());
  }

  @Test
  void agreesWithExactArithmeticUpToTenMillionSizesAway() {
    final ExactTrial trial = new ExactTrial("exact egg");
    final RandomNumbers numbers = trial.numbers();
    for (int k = 0; k < 40; k++) {
      final float b = numbers.magnitude(-20, 20), a = b * numbers.magnitude(-2, 2);
      final float w = b * (float) numbers.between(0.01, 0.95);
      final Point3D C = numbers.pointAbout(new Point3D(), b * numbers.magnitude(-3, 3));
      final Vector3D u = numbers.direction();
      trial.ask(new Egg(C, u, a, b, w, Color.RED), C, 1.1 * Math.max(a, b), RandomNumbers.times(40),
          new ExactEgg(C, u, a, b, w)::span);
    }
    trial.assertCounts(400, 300, 30);
  }

  /** Points and normals from 10⁴ sizes away, against the equation and its gradient. */
  @Test
  void farHitsLieOnTheSurfaceWithTheNormalOfTheGradient() {
    final RandomNumbers numbers = new RandomNumbers("far egg");
    for (int k = 0; k < 3000; k++) {
      final Ray ray = new Ray(numbers.pointAbout(O, 30000), numbers.pointAbout(new Point3D(0, -1, 0), 2));
      final Hit hit = EGG.intersectionWith(ray);
      if (hit.hits()) {
        final double x = hit.pointX(), y = hit.pointY(), z = hit.pointZ(), r2 = x * x + z * z, q = 29 + 4 * y;
        final double nx = x * q, ny = 2 * r2 + 9 * y, nz = z * q, n = Math.sqrt(nx * nx + ny * ny + nz * nz);
        assertEquals(0, (r2 * q - 9 * (25 - y * y)) / n, 1e-14, () -> ray + ", " + numbers);
        final double cosine = (nx * hit.normalX() + ny * hit.normalY() + nz * hit.normalZ()) / n;
        assertEquals(1, cosine, 1e-14, () -> ray + ", " + numbers);
      }
    }
  }

  @Test
  void aVanishingWMakesItTheEllipsoid() {
    final RandomNumbers numbers = new RandomNumbers("egg and ellipsoid");
    final Vector3D u = new Vector3D(1, 2, 3);
    final Egg egg = new Egg(new Point3D(1, 2, 3), u, 0.7f, 1.1f, 1e-9f, Color.RED);
    final Vector3D across = new Vector3D();
    across.cross(u, X);
    final Ellipsoid ellipsoid = new Ellipsoid(new Point3D(1, 2, 3), across, u, 0.7f, 1.1f, 0.7f, Color.RED);
    int hits = 0;
    for (int k = 0; k < 5000; k++) {
      final Ray ray = new Ray(numbers.pointAbout(new Point3D(), 5), numbers.pointAbout(new Point3D(1, 2, 3), 1));
      final Hit expected = ellipsoid.intersectionWith(ray), hit = egg.intersectionWith(ray);
      assertEquals(expected.hits(), hit.hits(), () -> ray + ", " + numbers);
      if (hit.hits()) {
        hits++;
        assertEquals(expected.getT(), hit.getT(), 1e-6 * (1 + hit.getT()), () -> ray + ", " + numbers);
        assertTrue(expected.getNormal().epsilonEquals(hit.getNormal(), 2e-6f), () -> ray + ", " + numbers);
      }
    }
    assertTrue(hits > 2000, hits + " hits");
  }

  /** All chords of one direction add up to the volume π ∫ a² (b² − y²) / (b² + 2 w y + w²) dy. */
  @ParameterizedTest
  @ValueSource(floats = {1e-6f, 0.5f, 2, 4, 4.9f})
  void chordsAddUpToTheVolume(final float w) {
    final Egg egg = new Egg(O, new Vector3D(1, 5, 2), 3, 5, w, Color.RED);
    double volume = 0, chords = 0;
    for (int i = 0; i < 20000; i++) {
      final double y = 5 * Math.cos(Math.PI * (i + 0.5) / 20000);
      volume += 9 * (25 - y * y) / (25 + 2 * w * y + w * w) * 5 * Math.sqrt(1 - y * y / 25) * Math.PI * Math.PI / 20000;
    }
    final int n = 400;
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        final double x = 12 * (i + 0.5) / n - 6, y = 12 * (j + 0.5) / n - 6;
        final double t = egg.distance(x, y, -20, 0, 0, 1);
        chords += t < 40 ? 40 - t - egg.distance(x, y, 20, 0, 0, -1) : 0;
      }
    }
    assertEquals(volume, chords * 144 / n / n, 5e-4 * volume);
  }

  /** The box touches the egg on all six sides: some hit comes close to each. */
  @Test
  void theBoxIsTight() {
    final BoundingBox upright = EGG.getBoundingBox();
    assertEquals(-3, upright.minX(), 1e-6);
    assertEquals(5, upright.maxY(), 1e-6);
    assertEquals(-5, upright.minY(), 1e-6);
    final RandomNumbers numbers = new RandomNumbers("box of the egg");
    final Egg egg = new Egg(new Point3D(1, 2, 3), new Vector3D(2, -1, 3), 3, 5, 2, Color.RED);
    final double[] least = {9, 9, 9}, most = {-9, -9, -9};
    for (int k = 0; k < 300000; k++) {
      final Hit hit = egg.intersectionWith(new Ray(new Point3D(1, 2, 3), numbers.direction()));
      final double[] P = {hit.pointX(), hit.pointY(), hit.pointZ()};
      for (int i = 0; i < 3; i++) {
        least[i] = Math.min(least[i], P[i]);
        most[i] = Math.max(most[i], P[i]);
      }
    }
    final BoundingBox box = egg.getBoundingBox();
    assertEquals(least[0], box.minX(), 1e-3);
    assertEquals(least[1], box.minY(), 1e-3);
    assertEquals(least[2], box.minZ(), 1e-3);
    assertEquals(most[0], box.maxX(), 1e-3);
    assertEquals(most[1], box.maxY(), 1e-3);
    assertEquals(most[2], box.maxZ(), 1e-3);
  }

  /** With w almost b the lower end is almost a flat disc: no ray from below passes through it. */
  @Test
  void aBluntEndIsClosed() {
    final Egg blunt = new Egg(O, Y, 3, 5, Math.nextDown(5f), Color.RED);
    final RandomNumbers numbers = new RandomNumbers("blunt egg");
    for (int k = 0; k < 20000; k++) {
      final double r = 2.999 * Math.sqrt(numbers.between(0, 1)), phi = numbers.between(0, 6.3);
      final Point3D on = new Point3D((float) (r * Math.cos(phi)), -5, (float) (r * Math.sin(phi)));
      final Point3D R = new Point3D(on.x + (float) numbers.between(-1, 1), -7, on.z + (float) numbers.between(-1, 1));
      final Hit hit = blunt.intersectionWith(new Ray(R, on));
      assertEquals(R.distance(on), hit.getT(), 1e-5, () -> R + ", " + on + ", " + numbers);
      assertEquals(-1, hit.normalY(), 1e-6, () -> R + ", " + on + ", " + numbers);
    }
  }

  @ParameterizedTest
  @ValueSource(floats = {1e-37f, 1e-20f, 1e20f, 1e37f})
  void sizesAtTheEndsOfTheFloatsWork(final float size) {
    final Egg egg = new Egg(O, Y, size, 2 * size, size, Color.RED);
    assertHit(3 * (double) size, new Point3D(0, 2 * size, 0), Y, egg,
        new Ray(new Point3D(0, 5 * size, 0), new Vector3D(0, -1, 0)));
    assertHit(2 * (double) size, new Point3D(size, -size, 0), X, egg,
        new Ray(new Point3D(3 * size, -size, 0), new Vector3D(-1, 0, 0)));
  }

  @Test
  void aNeedleAndADiscAreHit() {
    final Egg needle = new Egg(O, Y, 1e-4f, 5, 2, Color.RED), disc = new Egg(O, Y, 5, 1e-4f, 5e-5f, Color.RED);
    assertEquals(9, needle.intersectionWith(new Ray(new Point3D(9, 1, 0), new Vector3D(-1, 0, 0))).getT(), 1e-3);
    assertEquals(4, disc.intersectionWith(new Ray(new Point3D(1, 4, 1), new Vector3D(0, -1, 0))).getT(), 1e-3);
    final Ray across = new Ray(new Point3D(9, 0, 0), new Vector3D(-1, 0, 0));
    assertEquals(9 - 5 / Math.sqrt(1.25), disc.intersectionWith(across).getT(), 1e-5);
  }

  @Test
  void textAndArgumentsAreThoseOfTheConstructor() {
    assertEquals("Egg(C=(0.0, 0.0, 0.0), axis=(0.0, 1.0, 0.0), a=3.0, b=5.0, w=2.0)", EGG.toString());
    assertEquals("[(0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 3.0, 5.0, 2.0, " + Color.RED + "]",
        EGG.constructorArguments().toString());
  }
}
