package upnatray;

import java.awt.Color;
import java.util.Random;

import javax.vecmath.Vector3f;

import models.AffineTransformation;
import models.Box;
import models.Capsule;
import models.Cylinder;
import models.Egg;
import models.Ellipsoid;
import models.Group3D;
import models.Object3D;
import models.Plane;
import models.Sphere;
import models.Torus;
import models.Triangle;
import models.TriangularMesh;
import models.TruncatedCone;
import primitives.Point3D;
import primitives.Vector3D;

/**
 * A scene of random objects of all kinds near the origin, of sizes about a unit of length; and the same scene without
 * anything that culls objects: groups and meshes are {@link LinearGroup}s.
 */
final class RandomScene {

  /** An object, and the same for the oracle. */
  private record Pair(Object3D object, Object3D linear) {

    static Pair same(final Object3D object) {
      return new Pair(object, object);
    }
  }

  final Group3D scene = new Group3D();
  final LinearGroup linear = new LinearGroup();
  private final Random random;
  private final double unit;

  RandomScene(final Random random, final double unit, final int objects) {
    this.random = random;
    this.unit = unit;
    for (int i = 0; i < objects; i++) {
      final Pair pair = any(2);
      scene.addObject(pair.object);
      linear.addObject(pair.linear);
    }
  }

  private Pair any(final int depth) {
    switch (random.nextInt(depth > 0 ? 20 : 13)) {
      case 0: case 1: return Pair.same(new Sphere(point(), size(), color()));
      case 2: return Pair.same(new Box(point(), axis(), new Vector3D(0.3f, 1, 0.2f), size(), size(), size(), color()));
      case 3: return Pair.same(random.nextBoolean() ? new Cylinder(point(), axis(), size(), size(), color())
          : new TruncatedCone(point(), axis(), random.nextBoolean() ? 0 : size(), size(), size(), color()));
      case 4: return Pair.same(new Capsule(point(), axis(), size(), size(), color()));
      case 5: return Pair.same(new Torus(point(), axis(), size(), size(), color()));
      case 6: return random.nextInt(3) == 0 ? Pair.same(egg(size()))
          : Pair.same(new Ellipsoid(point(), axis(), new Vector3D(0.3f, 1, 0.2f), size(), size(), size(), color()));
      case 7: return Pair.same(new Triangle(point(), point(), point(), color()));
      case 8: return random.nextInt(4) > 0 ? any(depth) : Pair.same(new Plane(point(), axis(), color()));
      case 9: return Pair.same(new StudentsSphere(point(), size(), true, color()));
      case 10: return Pair.same(new StudentsSphere(point(), size(), false, color()));
      case 11: case 12: return mesh();
      case 13: case 14: case 15: return group(depth - 1);
      default: return transformed(any(depth - 1));
    }
  }

  private Egg egg(final float w) {
    return new Egg(point(), axis(), size(), w * (1.01f + random.nextFloat()), w, color());
  }

  private Pair group(final int depth) {
    final Group3D group = new Group3D();
    final LinearGroup list = new LinearGroup();
    for (int i = random.nextInt(6); i >= 0; i--) {
      final Pair pair = any(depth);
      group.addObject(pair.object);
      list.addObject(pair.linear);
    }
    return new Pair(group, list);
  }

  private Pair transformed(final Pair pair) {
    final float k = random.nextInt(8) == 0 ? 60 : 1;
    final Vector3f s = new Vector3f(factor() * k, factor(), random.nextInt(6) == 0 ? 0.01f : factor());
    final Vector3f axis = new Vector3f(gauss(), gauss(), gauss());
    final Vector3f d = new Vector3f(point());
    final float theta = random.nextInt(4) == 0 ? 90 * random.nextInt(4) : 360 * random.nextFloat();
    return new Pair(new AffineTransformation(s, axis, theta, d, pair.object),
        new AffineTransformation(s, axis, theta, d, pair.linear));
  }

  private float factor() {
    return (random.nextBoolean() ? 1 : -1) * (0.4f + 2 * random.nextFloat());
  }

  private Pair mesh() {
    switch (random.nextInt(4)) {
      case 0: return mesh(soup(1 + random.nextInt(40)));
      case 1: return mesh(grid(2 + random.nextInt(8)));
      default: return mesh(ball(3 + random.nextInt(8)));
    }
  }

  /** Coordinates of the corners of triangles, nine numbers each, as a mesh in the same order. */
  private Pair mesh(final float[] corners) {
    final int[] numbers = new int[corners.length / 3];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = i;
    }
    final TriangularMesh mesh = TriangularMesh.of(corners, numbers, random.nextBoolean() ? color() : null);
    final LinearGroup list = new LinearGroup();
    mesh.getTriangles().forEach(list::addObject);
    return new Pair(mesh, list);
  }

  private float[] soup(final int triangles) {
    final float[] corners = new float[9 * triangles];
    for (int i = 0; i < corners.length; i++) {
      corners[i] = (float) (unit * gauss());
    }
    return corners;
  }

  /** A flat piece of a plane along the axes, whose box has no thickness. */
  private float[] grid(final int n) {
    final float[] corners = new float[18 * n * n];
    final Point3D P = point();
    final int flat = random.nextInt(3);
    int at = 0;
    for (int i = 0; i < 6 * n * n; i++) {
      final int cell = i / 6, corner = "012213".charAt(i % 6) - '0';
      final float a = (float) (0.3 * unit * (cell % n + corner % 2)), b = (float) (0.3 * unit * (cell / n + corner / 2));
      corners[at++] = P.x + (flat == 0 ? 0 : a);
      corners[at++] = P.y + (flat == 1 ? 0 : flat == 0 ? a : b);
      corners[at++] = P.z + (flat == 2 ? 0 : b);
    }
    return corners;
  }

  /** A closed surface of 2 n² triangles. */
  private float[] ball(final int n) {
    final float[] corners = new float[18 * n * n];
    final Point3D C = point();
    final double r = size();
    int at = 0;
    for (int i = 0; i < 6 * n * n; i++) {
      final int cell = i / 6, corner = "012213".charAt(i % 6) - '0';
      final int meridian = (cell % n + corner % 2) % n, parallel = cell / n + corner / 2;
      final double longitude = 2 * Math.PI * meridian / n, latitude = Math.PI * parallel / n;
      final double rho = parallel == 0 || parallel == n ? 0 : r * Math.sin(latitude);
      corners[at++] = (float) (C.x + rho * Math.cos(longitude));
      corners[at++] = (float) (C.y + rho * Math.sin(longitude));
      corners[at++] = (float) (C.z - r * Math.cos(latitude));
    }
    return corners;
  }

  Point3D point() {
    return new Point3D((float) (unit * gauss()), (float) (unit * gauss()), (float) (unit * gauss()));
  }

  private float gauss() {
    return (float) random.nextGaussian();
  }

  /** Mostly moderate, sometimes tiny or large. */
  private float size() {
    final double exponent = random.nextInt(8) == 0 ? 4 * random.nextDouble() - 3 : -0.3 - random.nextDouble();
    return (float) (unit * Math.pow(10, exponent));
  }

  private Vector3D axis() {
    return random.nextInt(4) == 0 ? new Vector3D(0, 0, 1) : new Vector3D(gauss(), gauss(), gauss());
  }

  private Color color() {
    return new Color(random.nextInt(), true);
  }
}
