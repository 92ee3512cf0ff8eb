package upnatray;

import java.awt.Color;
import java.util.concurrent.TimeUnit;

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

import javax.vecmath.Vector3f;

import models.AffineTransformation;
import models.Box;
import models.Capsule;
import models.Cylinder;
import models.Ellipsoid;
import models.Group3D;
import models.Object3D;
import models.Plane;
import models.Sphere;
import models.Torus;
import models.Triangle;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

/** Time of a single ray with each shape, through {@code intersectionWith}; {@code -prof gc} adds the bytes allocated. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(2)
public class ShapeBenchmark {

  private static final int RAYS = 1 << 12;

  /** Kind of the shape. */
  @Param({"sphere", "plane", "triangle", "cylinder", "capsule", "box", "torus", "ellipsoid", "transformed sphere",
      "mesh 100k", "group of 9"})
  public String shape;

  private Object3D object;
  private Ray[] rays;

  /** Makes the shape and the rays. */
  @Setup
  public void make() {
    object = object(shape);
    rays = BenchmarkScene.rays(RAYS);
  }

  private static Object3D object(final String name) {
    final Point3D O = new Point3D();
    final Vector3D x = new Vector3D(1, 0, 0), y = new Vector3D(0, 1, 0);
    final Color color = Color.RED;
    return switch (name) {
      case "sphere" -> new Sphere(O, 0.7f, color);
      case "plane" -> new Plane(O, y, color);
      case "triangle" -> new Triangle(new Point3D(-1, -1, 0), new Point3D(1, -1, 0), new Point3D(0, 1, 0), color);
      case "cylinder" -> new Cylinder(O, y, 0.5f, 1, color);
      case "capsule" -> new Capsule(O, y, 0.4f, 1, color);
      case "box" -> new Box(O, x, y, 1, 1, 1, color);
      case "torus" -> new Torus(O, y, 0.6f, 0.25f, color);
      case "ellipsoid" -> new Ellipsoid(O, x, y, 0.9f, 0.6f, 0.4f, color);
      case "transformed sphere" -> new AffineTransformation(new Vector3f(1, 0.5f, 0.7f), new Vector3f(0, 0, 1), 30,
          new Vector3f(0.1f, 0, 0), new Sphere(O, 0.8f, color));
      case "mesh 100k" -> BenchmarkScene.mesh(100_000);
      default -> group();
    };
  }

  private static Group3D group() {
    final Group3D group = new Group3D();
    for (int i = 0; i < 9; i++) {
      group.addObject(new Sphere(new Point3D(0.5f * (i % 3 - 1), 0.5f * (i / 3 - 1), 0), 0.2f, Color.RED));
    }
    return group;
  }

  /**
   * Sends the rays.
   *
   * @return a number that depends on all results
   */
  @Benchmark
  @OperationsPerInvocation(RAYS)
  public int ray() {
    int hits = 0;
    for (final Ray ray : rays) {
      hits += object.intersectionWith(ray).hits() ? 1 : 0;
    }
    return hits;
  }
}
