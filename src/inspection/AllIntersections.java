package inspection;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;

import models.AffineTransformation;
import models.Group3D;
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

/** Asks all objects of a scene for one ray, groups and transformations opened up. */
final class AllIntersections {

  /** What the point of a hit may be off the ray, as a part of its distance and of its coordinates. */
  private static final double OFF = 1e-4;

  private final SceneFile scene;
  private final Ray sceneRay;
  private final List<Intersection> meetings = new ArrayList<>();
  private final Set<Object3D> seen = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Deque<AffineTransformation> transformations = new ArrayDeque<>();
  private final Deque<Ray> rays = new ArrayDeque<>();
  private Object3D whole;
  private String name = "";

  AllIntersections(final SceneFile scene, final Ray ray) {
    this.scene = scene;
    this.sceneRay = ray;
  }

  List<Intersection> all() {
    rays.push(sceneRay);
    askParts(scene.objects());
    return meetings;
  }

  private void askParts(final Group3D group) {
    for (final Object3D part : group.getObjects()) {
      if (transformations.isEmpty()) {
        if (!seen.add(part)) {
          continue;
        }
        whole = part;
        name = scene.names().getOrDefault(part, "");
      }
      ask(part);
    }
  }

  private void ask(final Object3D object) {
    if (object instanceof Group3D group) {
      askParts(group);
    } else if (object instanceof AffineTransformation transformation) {
      transformations.push(transformation);
      rays.push(transformation.rayToObject(rays.peek()));
      ask(transformation.getObject());
      rays.pop();
      transformations.pop();
    } else {
      askShape(object);
    }
  }

  private void askShape(final Object3D object) {
    final List<ContractViolation> findings = new ArrayList<>();
    Hit hit = Hit.NOHIT;
    String failure = "";
    try {
      final Hit answer = object.intersectionWith(rays.peek());
      if (answer == null) {
        findings.add(ContractViolation.NULL_HIT);
      } else {
        hit = answer;
        check(object, hit, findings);
      }
    } catch (final RuntimeException | StackOverflowError thrown) {
      findings.add(ContractViolation.EXCEPTION);
      failure = text(thrown);
    }
    final Optional<SphereTrace> march = march(object, hit.hits() || !findings.isEmpty());
    if (hit.hits() || !findings.isEmpty() || march.isPresent()) {
      final List<LocalRay> frames = new ArrayList<>();
      final Hit inScene = inScene(hit, frames);
      meetings.add(new Intersection(object, whole, name, inScene, false, frames, march, findings, failure));
    }
  }

  /** What was thrown and where it comes from, as a file of sources and a line, if that is known. */
  private static String text(final Throwable thrown) {
    return thrown.getClass().getSimpleName() + (thrown.getMessage() == null ? "" : ": " + thrown.getMessage())
        + ThrowSite.of(thrown).map(call -> " (" + call.getFileName() + ":" + call.getLineNumber() + ")").orElse("");
  }

  /** The march to an object; to one that is not met only if the ray crosses its box: then it is told why it was not met. */
  private Optional<SphereTrace> march(final Object3D object, final boolean isMet) {
    try {
      return isMet || isCrossed(object.getBoundingBox()) ? SphereTrace.of(object, rays.peek()) : Optional.empty();
    } catch (final RuntimeException | StackOverflowError undefined) {
      return Optional.empty();
    }
  }

  private boolean isCrossed(final BoundingBox box) {
    final Ray ray = rays.peek();
    return box.isCrossedBy(ray.startX(), ray.startY(), ray.startZ(), ray.directionX(), ray.directionY(), ray.directionZ());
  }

  private void check(final Object3D object, final Hit hit, final List<ContractViolation> findings) {
    final Hit again = object.intersectionWith(rays.peek());
    if (again == null || again.getT() != hit.getT()) {
      findings.add(ContractViolation.UNSTEADY);
    }
    if (!hit.hits()) {
      return;
    }
    if (isOffRay(hit)) {
      findings.add(ContractViolation.POINT_OFF_RAY);
    }
    checkBox(object, hit, findings);
  }

  private boolean isOffRay(final Hit hit) {
    final Ray ray = rays.peek();
    final double t = hit.getT();
    final double x = ray.startX() + t * ray.directionX() - hit.pointX(), y = ray.startY() + t * ray.directionY()
        - hit.pointY(), z = ray.startZ() + t * ray.directionZ() - hit.pointZ();
    final double size = t + Math.abs(hit.pointX()) + Math.abs(hit.pointY()) + Math.abs(hit.pointZ());
    return !(Math.sqrt(x * x + y * y + z * z) <= OFF * size);
  }

  private void checkBox(final Object3D object, final Hit hit, final List<ContractViolation> findings) {
    final Ray ray = rays.peek();
    final BoundingBox box = object.getBoundingBox();
    if (box == null) {
      findings.add(ContractViolation.NULL_BOX);
      return;
    }
    if (!isCrossed(box)) {
      findings.add(ContractViolation.BOX_PASSED_BY);
    }
    if (!box.contains(hit.getPoint())) {
      findings.add(ContractViolation.POINT_OUTSIDE_BOX);
    }
    final boolean open = object instanceof Plane || object instanceof Triangle || object instanceof TriangularMesh;
    final Point3D R = ray.getStartingPoint();
    if (!open && box.isFinite() && !box.contains(R) && hit.normalX() * ray.directionX()
        + hit.normalY() * ray.directionY() + hit.normalZ() * ray.directionZ() > OFF) {
      findings.add(ContractViolation.NORMAL_INWARD);
    }
  }

  /** Takes a hit out of all transformations, and notes what it is in the frame of each. */
  private Hit inScene(final Hit hit, final List<LocalRay> frames) {
    final Ray[] inner = rays.toArray(new Ray[0]);
    Hit outside = hit;
    int i = 0;
    for (final AffineTransformation transformation : transformations) {
      frames.add(0, new LocalRay(transformation, inner[i], outside));
      outside = transformation.hitToScene(inner[++i], outside);
    }
    return outside;
  }
}
