package models;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;

import org.junit.jupiter.api.Test;

import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;

/** The box of a shape in any position is the least about the points of its surface, which are written down one by one. */
class BoundsOfShapesTest {

  private static final int TRIALS = RandomNumbers.times(200);
  private static final int ANGLES = 720;

  /** A right-handed frame at a place, in which points are given. */
  private static final class Placement {

    private final Point3D C;
    private final double[] u;
    private final double[] v;
    private final double[] w;

    Placement(final RandomNumbers numbers) {
      C = numbers.pointAbout(new Point3D(), 20);
      u = unit(numbers.direction());
      final Vector3D any = numbers.direction();
      w = unit(cross(u, new double[] {any.x, any.y, any.z}));
      v = cross(w, u);
    }

    private static double[] unit(final Vector3D a) {
      return unit(new double[] {a.x, a.y, a.z});
    }

    private static double[] unit(final double[] a) {
      final double length = Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
      return new double[] {a[0] / length, a[1] / length, a[2] / length};
    }

    private static double[] cross(final double[] a, final double[] b) {
      return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    Vector3D first() {
      return vector(u);
    }

    Vector3D second() {
      return vector(v);
    }

    private static Vector3D vector(final double[] a) {
      return new Vector3D((float) a[0], (float) a[1], (float) a[2]);
    }

    double[] point(final double a, final double b, final double c) {
      return new double[] {C.x + a * u[0] + b * v[0] + c * w[0], C.y + a * u[1] + b * v[1] + c * w[1],
          C.z + a * u[2] + b * v[2] + c * w[2]};
    }

    /** The points of a circle about the first axis. */
    List<double[]> circle(final double at, final double r) {
      final List<double[]> points = new ArrayList<>();
      for (int i = 0; i < ANGLES; i++) {
        final double angle = 2 * Math.PI * i / ANGLES;
        points.add(point(at, r * Math.cos(angle), r * Math.sin(angle)));
      }
      return points;
    }
  }

  /** The six points of balls about some points that lie farthest along the axes. */
  private static List<double[]> balls(final double r, final List<double[]> centres) {
    final List<double[]> points = new ArrayList<>();
    for (final double[] centre : centres) {
      for (int i = 0; i < 6; i++) {
        final double[] point = centre.clone();
        point[i / 2] += i % 2 == 0 ? r : -r;
        points.add(point);
      }
    }
    return points;
  }

  private static void assertLeastAbout(final List<double[]> points, final Object3D shape) {
    final BoundingBox box = shape.getBoundingBox();
    final float[] min = {box.minX(), box.minY(), box.minZ()}, max = {box.maxX(), box.maxY(), box.maxZ()};
    for (int i = 0; i < 3; i++) {
      final int axis = i;
      final double least = points.stream().mapToDouble(p -> p[axis]).min().orElseThrow();
      final double most = points.stream().mapToDouble(p -> p[axis]).max().orElseThrow();
      final double slack = 2e-5 * (max[i] - min[i]) + 4e-6;
      assertEquals(least, min[i], slack, () -> shape + ": " + box);
      assertEquals(most, max[i], slack, () -> shape + ": " + box);
    }
  }

  @Test
  void boxOfACylinderIsTheLeastAboutItsRims() {
    final RandomNumbers numbers = new RandomNumbers("box of a cylinder");
    for (int i = 0; i < TRIALS; i++) {
      final Placement at = new Placement(numbers);
      final float r = numbers.magnitude(-3, 3), l = numbers.magnitude(-3, 3);
      final List<double[]> points = at.circle(0.5 * l, r);
      points.addAll(at.circle(-0.5 * l, r));
      assertLeastAbout(points, new Cylinder(at.C, at.first(), r, l, Color.RED));
    }
  }

  @Test
  void boxOfATruncatedConeIsTheLeastAboutItsRims() {
    final RandomNumbers numbers = new RandomNumbers("box of a cone");
    for (int i = 0; i < TRIALS; i++) {
      final Placement at = new Placement(numbers);
      final float a = numbers.magnitude(-3, 3), b = numbers.magnitude(-3, 3), l = numbers.magnitude(-3, 3);
      final List<double[]> points = at.circle(-0.5 * l, a);
      points.addAll(at.circle(0.5 * l, b));
      assertLeastAbout(points, new TruncatedCone(at.C, at.first(), a, b, l, Color.RED));
    }
  }

  @Test
  void boxOfACapsuleIsTheLeastAboutItsTwoBalls() {
    final RandomNumbers numbers = new RandomNumbers("box of a capsule");
    for (int i = 0; i < TRIALS; i++) {
      final Placement at = new Placement(numbers);
      final float r = numbers.magnitude(-3, 3), l = numbers.magnitude(-3, 3);
      assertLeastAbout(balls(r, List.of(at.point(0.5 * l, 0, 0), at.point(-0.5 * l, 0, 0))),
          new Capsule(at.C, at.first(), r, l, Color.RED));
    }
  }

  @Test
  void boxOfATorusIsTheLeastAboutTheBallsOfItsRing() {
    final RandomNumbers numbers = new RandomNumbers("box of a torus");
    for (int i = 0; i < TRIALS; i++) {
      final Placement at = new Placement(numbers);
      final float R = numbers.magnitude(-3, 3), r = numbers.magnitude(-3, 3);
      assertLeastAbout(balls(r, at.circle(0, R)), new Torus(at.C, at.first(), R, r, Color.RED));
    }
  }

  @Test
  void boxOfABoxIsTheLeastAboutItsCorners() {
    final RandomNumbers numbers = new RandomNumbers("box of a box");
    for (int i = 0; i < TRIALS; i++) {
      final Placement at = new Placement(numbers);
      final float w = numbers.magnitude(-3, 3), h = numbers.magnitude(-3, 3), d = numbers.magnitude(-3, 3);
      final List<double[]> corners = new ArrayList<>();
      for (int k = 0; k < 8; k++) {
        corners.add(at.point((k % 2 - 0.5) * w, (k / 2 % 2 - 0.5) * h, (k / 4 - 0.5) * d));
      }
      assertLeastAbout(corners, new Box(at.C, at.first(), at.second(), w, h, d, Color.RED));
    }
  }

  /** Its points farthest along the axes are those whose normals are the axes: p = Q² n / |Q n| with the half axes in Q. */
  @Test
  void boxOfAnEllipsoidIsTheLeastAboutItsFarthestPoints() {
    final RandomNumbers numbers = new RandomNumbers("box of an ellipsoid");
    for (int i = 0; i < TRIALS; i++) {
      final Placement at = new Placement(numbers);
      final float a = numbers.magnitude(-2, 2), b = numbers.magnitude(-2, 2), c = numbers.magnitude(-2, 2);
      final List<double[]> points = new ArrayList<>();
      for (int k = 0; k < 3; k++) {
        final double x = a * at.u[k], y = b * at.v[k], z = c * at.w[k], length = Math.sqrt(x * x + y * y + z * z);
        points.add(at.point(a * x / length, b * y / length, c * z / length));
        points.add(at.point(-a * x / length, -b * y / length, -c * z / length));
      }
      assertLeastAbout(points, new Ellipsoid(at.C, at.first(), at.second(), a, b, c, Color.RED));
    }
  }
}
