package inspection;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;

import models.SphereTrace;
import models.Object3D;
import models.Plane;
import models.Triangle;
import models.TriangularMesh;
import primitives.BoundingBox;
import primitives.Point3D;
import scenes.SceneFile;
import tracer.Hit;
import tracer.Ray;

/** Intersects one ray with every object of a scene, descending into groups and transformations. */
final class AllIntersections {

  /** Largest distance of a hit's point from R + t v, relative to t and the point's coordinates. */
  private static final double TOLERANCE = 1e-4;

  private final SceneFile scene;
  private final Ray sceneRay;
  private final List<Intersection> intersections = new ArrayList<>();
  private final Set<Object3D> seen = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Deque<Object3D> transformations = new ArrayDeque<>();
  private final Deque<Ray> rays = new ArrayDeque<>();
  private Object3D sceneObject;
  private String name = "";

  AllIntersections(final SceneFile scene, final Ray ray) {
    this.scene = scene;
    this.sceneRay = ray;
  }

  List<Intersection> all() {
    rays.push(sceneRay);
    visitParts(scene.objects());
    return intersections;
  }

  private void visitParts(final Object3D whole) {
    for (final Object3D part : whole.parts()) {
      if (transformations.isEmpty()) {
        if (!seen.add(part)) {
          continue;
        }
        sceneObject = part;
        name = scene.names().getOrDefault(part, "");
      }
      visit(part);
    }
  }

  private void visit(final Object3D object) {
    final Ray ray = rays.peek(), inner = object.rayToParts(ray);
    if (object.parts().isEmpty()) {
      testShape(object);
    } else if (inner == ray) {
      visitParts(object);
    } else {
      transformations.push(object);
      rays.push(inner);
      visitParts(object);
      rays.pop();
      transformations.pop();
    }
  }

  private void testShape(final Object3D object) {
    final List<ContractViolation> violations = new ArrayList<>();
    Hit hit = Hit.NOHIT;
    String failure = "";
    try {
      final Hit result = object.intersectionWith(rays.peek());
      if (result == null) {
        violations.add(ContractViolation.NULL_HIT);
      } else {
        hit = result;
        check(object, hit, violations);
      }
    } catch (final RuntimeException | StackOverflowError thrown) {
      violations.add(ContractViolation.EXCEPTION);
      failure = text(thrown);
    }
    final Optional<SphereTrace> trace = trace(object, hit.hits() || !violations.isEmpty());
    if (hit.hits() || !violations.isEmpty() || trace.isPresent()) {
      final List<LocalRay> localRays = new ArrayList<>();
      final Hit sceneHit = toScene(hit, localRays);
      intersections.add(new Intersection(object, sceneObject, name, sceneHit, false, localRays, trace, violations, failure));
    }
  }

  /** The exception and, if known, the source line that caused it. */
  private static String text(final Throwable thrown) {
    return thrown.getClass().getSimpleName() + (thrown.getMessage() == null ? "" : ": " + thrown.getMessage())
        + ThrowSite.of(thrown).map(call -> " (" + call.getFileName() + ":" + call.getLineNumber() + ")").orElse("");
  }

  /** The sphere trace of a procedural object; of one that is missed only if the ray crosses its box. */
  private Optional<SphereTrace> trace(final Object3D object, final boolean hits) {
    try {
      return hits || isCrossed(object.getBoundingBox()) ? SphereTrace.of(object, rays.peek()) : Optional.empty();
    } catch (final RuntimeException | StackOverflowError undefined) {
      return Optional.empty();
    }
  }

  private boolean isCrossed(final BoundingBox box) {
    final Ray ray = rays.peek();
    return box.isCrossedBy(ray.startX(), ray.startY(), ray.startZ(), ray.directionX(), ray.directionY(), ray.directionZ());
  }

  private void check(final Object3D object, final Hit hit, final List<ContractViolation> violations) {
    final Hit again = object.intersectionWith(rays.peek());
    if (again == null || again.getT() != hit.getT()) {
      violations.add(ContractViolation.INCONSISTENT);
    }
    if (!hit.hits()) {
      return;
    }
    if (isPointOffRay(hit)) {
      violations.add(ContractViolation.POINT_OFF_RAY);
    }
    checkBox(object, hit, violations);
  }

  private boolean isPointOffRay(final Hit hit) {
    final Ray ray = rays.peek();
    final double t = hit.getT();
    final double x = ray.startX() + t * ray.directionX() - hit.pointX(), y = ray.startY() + t * ray.directionY()
        - hit.pointY(), z = ray.startZ() + t * ray.directionZ() - hit.pointZ();
    final double size = t + Math.abs(hit.pointX()) + Math.abs(hit.pointY()) + Math.abs(hit.pointZ());
    return !(Math.sqrt(x * x + y * y + z * z) <= TOLERANCE * size);
  }

  private void checkBox(final Object3D object, final Hit hit, final List<ContractViolation> violations) {
    final Ray ray = rays.peek();
    final BoundingBox box = object.getBoundingBox();
    if (box == null) {
      violations.add(ContractViolation.NULL_BOX);
      return;
    }
    if (!isCrossed(box)) {
      violations.add(ContractViolation.BOX_MISSED_BY_RAY);
    }
    if (!box.contains(hit.getPoint())) {
      violations.add(ContractViolation.POINT_OUTSIDE_BOX);
    }
    final boolean open = object instanceof Plane || object instanceof Triangle || object instanceof TriangularMesh;
    final Point3D R = ray.getStartingPoint();
    if (!open && box.isFinite() && !box.contains(R) && hit.normalX() * ray.directionX()
        + hit.normalY() * ray.directionY() + hit.normalZ() * ray.directionZ() > TOLERANCE) {
      violations.add(ContractViolation.NORMAL_INWARD);
    }
  }

  /** Transforms a hit to the scene, recording ray and hit in the frame of each transformation. */
  private Hit toScene(final Hit hit, final List<LocalRay> localRays) {
    final Ray[] inner = rays.toArray(new Ray[0]);
    Hit outer = hit;
    int i = 0;
    for (final Object3D transformation : transformations) {
      localRays.add(0, new LocalRay(transformation, inner[i], outer));
      outer = transformation.hitFromParts(inner[++i], outer);
    }
    return outer;
  }
}
