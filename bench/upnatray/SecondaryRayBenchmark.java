package upnatray;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

import models.Group3D;
import models.Sphere;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import primitives.Point3D;
import tracer.Hit;
import tracer.Ray;

/** Time of single rays that leave a surface: shadow rays to a light, and reflected ones; {@code -prof gc} adds the bytes. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(2)
public class SecondaryRayBenchmark {

  private static final int RAYS = 1 << 12;

  /** What the rays hit. */
  @Param({"mesh 100k", "1000 spheres"})
  public String object;

  private final Group3D scene = new Group3D();
  private Ray[] shadow;
  private Ray[] reflected;

  /** Makes the scene, and rays from its surfaces. */
  @Setup
  public void make() {
    if (object.startsWith("mesh")) {
      scene.addObject(BenchmarkScene.mesh(100_000));
    } else {
      for (final Ray ray : BenchmarkScene.rays(1000)) {
        final Point3D P = ray.pointAtParameter(5);
        scene.addObject(new Sphere(P, 0.1f, Color.RED));
      }
    }
    final List<Ray> toLight = new ArrayList<>(), mirrored = new ArrayList<>();
    while (toLight.size() < RAYS) {
      for (final Ray ray : BenchmarkScene.rays(RAYS)) {
        final Hit hit = scene.intersectionWith(ray);
        if (hit.hits() && toLight.size() < RAYS) {
          leave(ray, hit, toLight, mirrored);
        }
      }
    }
    shadow = toLight.toArray(new Ray[0]);
    reflected = mirrored.toArray(new Ray[0]);
  }

  private static void leave(final Ray ray, final Hit hit, final List<Ray> toLight, final List<Ray> mirrored) {
    final double x = 3 - hit.pointX(), y = 5 - hit.pointY(), z = 2 - hit.pointZ(), d = Math.sqrt(x * x + y * y + z * z);
    final double nx = hit.geometricX(), ny = hit.geometricY(), nz = hit.geometricZ();
    toLight.add(hit.leave(x * nx + y * ny + z * nz > 0, x / d, y / d, z / d));
    final double k = 2 * (ray.directionX() * nx + ray.directionY() * ny + ray.directionZ() * nz);
    mirrored.add(hit.leave(k < 0, ray.directionX() - k * nx, ray.directionY() - k * ny, ray.directionZ() - k * nz));
  }

  /**
   * Asks whether anything lies before the light.
   *
   * @return something that depends on all results
   */
  @Benchmark
  @OperationsPerInvocation(RAYS)
  public int shadow() {
    int blocked = 0;
    for (final Ray ray : shadow) {
      blocked += scene.intersectAny(ray, 5) ? 1 : 0;
    }
    return blocked;
  }

  /**
   * Finds what mirrors show.
   *
   * @return something that depends on all results
   */
  @Benchmark
  @OperationsPerInvocation(RAYS)
  public int reflected() {
    int hits = 0;
    for (final Ray ray : reflected) {
      hits += scene.intersectionWith(ray).hits() ? 1 : 0;
    }
    return hits;
  }
}
