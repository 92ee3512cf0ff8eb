import java.awt.Color;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

import models.Ellipsoid;
import models.SphereTrace;
import models.Object3D;
import models.Torus;
import models.TriangularMesh;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

/** The numbers of the report that no test prints: rays lost at the edges of a mesh, and steps of marches. */
public final class Measurements {

  private static final int RAYS = 40_000;
  private static final int LEVELS = 4;
  private static final float HART_CONTACT = 1e-4f;
  private static final int HART_STEPS = 100;
  private static final float FAR = 100;
  private static final Point3D ORIGIN = new Point3D();

  private final Random random = new Random(1);
  private final List<Point3D[]> triangles = new ArrayList<>();

  private Measurements() {
  }

  /** Prints the numbers. */
  public static void main(final String... arguments) {
    new Measurements().cracks();
    new Measurements().steps("torus 1, 0.01", new Torus(ORIGIN, new Vector3D(0, 1, 0), 1, 0.01f, Color.RED), 0.01f, true);
    new Measurements().steps("torus 1, 0.001", new Torus(ORIGIN, new Vector3D(0, 1, 0), 1, 0.001f, Color.RED), 0.001f, true);
    for (final float length : new float[] {10, 100}) {
      new Measurements().steps("ellipsoid 1 : " + length, new Ellipsoid(ORIGIN, new Vector3D(1, 0, 0), new Vector3D(0, 1, 0),
          1, 1 / length, 1 / length, Color.RED), 1 / length, false);
    }
  }

  private Point3D point(final double size) {
    return new Point3D((float) (size * random.nextGaussian()), (float) (size * random.nextGaussian()),
        (float) (size * random.nextGaussian()));
  }

  /** From the middle of a closed mesh through points of its edges: each ray that hits nothing is lost. */
  private void cracks() {
    octahedron();
    final Object3D mesh = mesh();
    final int[] lost = new int[3];
    for (int i = 0; i < RAYS; i++) {
      final Point3D[] triangle = triangles.get(random.nextInt(triangles.size()));
      final Point3D target = new Point3D();
      target.interpolate(triangle[0], triangle[1], random.nextFloat());
      final Ray ray = new Ray(point(0.05), target);
      lost[0] += triangles.stream().anyMatch(t -> hitsFloat(ray, t)) ? 0 : 1;
      lost[1] += triangles.stream().anyMatch(t -> hitsDouble(ray, t)) ? 0 : 1;
      lost[2] += mesh.intersectionWith(ray).hits() ? 0 : 1;
    }
    System.out.printf("lost at edges of %d rays: Moeller-Trumbore float %d, double %d, ours %d%n",
        RAYS, lost[0], lost[1], lost[2]);
  }

  private void octahedron() {
    for (int i = 0; i < 8; i++) {
      divide(new Point3D((i & 1) * 2 - 1, 0, 0), new Point3D(0, (i & 2) - 1, 0), new Point3D(0, 0, (i & 4) / 2 - 1), LEVELS);
    }
  }

  private void divide(final Point3D A, final Point3D B, final Point3D C, final int levels) {
    if (levels == 0) {
      triangles.add(new Point3D[] {A, B, C});
      return;
    }
    final Point3D a = middle(B, C), b = middle(C, A), c = middle(A, B);
    divide(A, c, b, levels - 1);
    divide(B, a, c, levels - 1);
    divide(C, b, a, levels - 1);
    divide(a, b, c, levels - 1);
  }

  private static Point3D middle(final Point3D P, final Point3D Q) {
    final Vector3D sum = new Vector3D(P.x + Q.x, P.y + Q.y, P.z + Q.z);
    sum.normalize();
    return new Point3D(sum.x, sum.y, sum.z);
  }

  private TriangularMesh mesh() {
    final Map<Integer, Point3D> vertices = new HashMap<>();
    final Map<Point3D, Integer> numbers = new HashMap<>();
    final List<String> facets = new ArrayList<>();
    for (final Point3D[] triangle : triangles) {
      final StringBuilder facet = new StringBuilder();
      for (final Point3D vertex : triangle) {
        final int number = numbers.computeIfAbsent(vertex, unknown -> numbers.size());
        vertices.put(number, vertex);
        facet.append(number).append(' ');
      }
      facets.add(facet.toString());
    }
    return new TriangularMesh(vertices, facets, Color.RED);
  }

  private static boolean hitsFloat(final Ray ray, final Point3D[] triangle) {
    final Point3D A = triangle[0], B = triangle[1], C = triangle[2], R = ray.getStartingPoint();
    final Vector3D d = ray.getDirection();
    final float ux = B.x - A.x, uy = B.y - A.y, uz = B.z - A.z, vx = C.x - A.x, vy = C.y - A.y, vz = C.z - A.z;
    final float px = d.y * vz - d.z * vy, py = d.z * vx - d.x * vz, pz = d.x * vy - d.y * vx;
    final float f = 1 / (ux * px + uy * py + uz * pz), sx = R.x - A.x, sy = R.y - A.y, sz = R.z - A.z;
    final float u = f * (sx * px + sy * py + sz * pz);
    final float qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
    final float v = f * (d.x * qx + d.y * qy + d.z * qz);
    return u >= 0 && v >= 0 && u + v <= 1 && f * (vx * qx + vy * qy + vz * qz) > 0;
  }

  private static boolean hitsDouble(final Ray ray, final Point3D[] triangle) {
    final Point3D A = triangle[0], B = triangle[1], C = triangle[2];
    final double dx = ray.directionX(), dy = ray.directionY(), dz = ray.directionZ(), ax = A.x, ay = A.y, az = A.z;
    final double ux = B.x - ax, uy = B.y - ay, uz = B.z - az, vx = C.x - ax, vy = C.y - ay, vz = C.z - az;
    final double px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
    final double f = 1 / (ux * px + uy * py + uz * pz);
    final double sx = ray.startX() - ax, sy = ray.startY() - ay, sz = ray.startZ() - az;
    final double u = f * (sx * px + sy * py + sz * pz);
    final double qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
    final double v = f * (dx * qx + dy * qy + dz * qz);
    return u >= 0 && v >= 0 && u + v <= 1 && f * (vx * qx + vy * qy + vz * qz) > 0;
  }

  /** Plain sphere tracing along rays near a thin torus or along an ellipsoid, and the results of the usual loop. */
  private void steps(final String name, final Object3D object, final float r, final boolean ring) {
    final int rays = RAYS / 20;
    long sum = 0;
    int most = 0, lost = 0, invented = 0;
    for (int i = 0; i < rays; i++) {
      final Ray ray = ring ? new Ray(point(2), nearRing(2 * r)) : new Ray(along(-2, r), along(2, r));
      final int steps = SphereTrace.of(object, ray).map(march -> march.steps().size()).orElse(0);
      sum += steps;
      most = Math.max(most, steps);
      if (ring) {
        final boolean hits = object.intersectionWith(ray).hits(), reached = reaches(ray, r);
        lost += hits && !reached ? 1 : 0;
        invented += !hits && reached ? 1 : 0;
      }
    }
    System.out.printf("%s: steps of plain sphere tracing %.1f on average, at most %d; "
        + "the float loop loses %d and invents %d of %d%n", name, sum / (double) rays, most, lost, invented, rays);
  }

  private Point3D nearRing(final double distance) {
    final double angle = 2 * Math.PI * random.nextDouble();
    final Point3D P = point(distance);
    P.add(new Point3D((float) Math.cos(angle), 0, (float) Math.sin(angle)));
    return P;
  }

  private Point3D along(final double x, final double distance) {
    final Point3D P = point(distance);
    P.x = (float) x;
    return P;
  }

  /** The usual loop: a hundred steps, each of the distance in float, until it is below 1e-4. */
  private static boolean reaches(final Ray ray, final float r) {
    float t = 0;
    for (int i = 0; i < HART_STEPS && t < FAR; i++) {
      final Point3D P = ray.pointAtParameter(t);
      final float ring = (float) Math.sqrt(P.x * P.x + P.z * P.z) - 1;
      final float distance = (float) Math.sqrt(ring * ring + P.y * P.y) - r;
      if (Math.abs(distance) < HART_CONTACT) {
        return true;
      }
      t += distance;
    }
    return false;
  }
}
