package models;

import static arguments.Arguments.notNull;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import primitives.Point3D;
import tracer.Hit;
import tracer.Ray;

/**
 * The steps of a march along a ray: sphere tracing by the signed distance of an object and an upper bound of it alone.
 *
 * <p>These are the steps of an object that finds its intersections by {@code rayMarching}. {@link Torus} and
 * {@link Ellipsoid} take longer steps, which lead to the same point.
 *
 * @param steps the points where the distance was evaluated, in order; t decreases where a step was too long
 * @param limit t beyond which the object cannot be
 * @param end why it ended
 * @param t distance to the surface along the ray; infinity if it was not reached
 */
public record SphereTrace(List<Step> steps, double limit, End end, double t) {

  /**
   * A point of the march.
   *
   * @param t distance from the start of the ray
   * @param distance signed distance to the surface there, negative inside
   */
  public record Step(double t, double distance) {
  }

  /** Why a march ended. */
  public enum End {
    /** The sign of the distance changed: the surface lies between the last two steps. */
    REACHED,
    /** It passed the farthest point where the object can be. */
    PASSED,
    /** The distance was not a number. */
    UNDEFINED,
    /** It reached the maximum number of steps. */
    GIVEN_UP
  }

  /**
   * Copies the list.
   *
   * @param steps the points where the distance was evaluated, in order; t decreases where a step was too long
   * @param limit t beyond which the object cannot be
   * @param end why it ended
   * @param t distance to the surface along the ray; infinity if it was not reached
   */
  public SphereTrace {
    steps = List.copyOf(steps);
  }

  /**
   * The march of an object along a ray.
   *
   * @param object any object
   * @param ray the ray, in the object's frame
   * @return the march; empty if the object is not ray-marched, or for {@link Ray#NORAY}
   * @throws IllegalArgumentException if an argument is null
   */
  public static Optional<SphereTrace> of(final Object3D object, final Ray ray) {
    notNull("object", object);
    return notNull("ray", ray) != Ray.NORAY && object instanceof ProceduralObject3D
        ? Optional.of(along(ray, (ProceduralObject3D) object)) : Optional.empty();
  }

  static SphereTrace along(final Ray ray, final ProceduralObject3D object) {
    return new Recorder(object, ray).march();
  }

  /** Marches as the object would by its distance alone, and records where the distance is evaluated. */
  private static final class Recorder extends ProceduralObject3D {

    private final ProceduralObject3D object;
    private final Ray ray;
    private final List<Step> steps = new ArrayList<>();
    private boolean refining;

    Recorder(final ProceduralObject3D object, final Ray ray) {
      super(object.getColor());
      this.object = object;
      this.ray = ray;
    }

    SphereTrace march() {
      final double reached = march(ray.startX(), ray.startY(), ray.startZ(),
          ray.directionX(), ray.directionY(), ray.directionZ());
      final double limit = distanceUpperBound(ray.getStartingPoint());
      return new SphereTrace(steps, limit, end(reached, limit), reached);
    }

    private End end(final double reached, final double limit) {
      if (reached < Double.POSITIVE_INFINITY) {
        return End.REACHED;
      }
      final Step last = steps.get(steps.size() - 1);
      if (Double.isNaN(last.distance)) {
        return End.UNDEFINED;
      }
      return last.t + 2 * Math.abs(last.distance) >= limit ? End.PASSED : End.GIVEN_UP;
    }

    /** At the start the same point is evaluated more than once. */
    @Override
    double signedDistance(final double x, final double y, final double z) {
      final double distance = object.signedDistance(x, y, z);
      final double t = (x - ray.startX()) * ray.directionX() + (y - ray.startY()) * ray.directionY()
          + (z - ray.startZ()) * ray.directionZ();
      final boolean again = !steps.isEmpty() && steps.get(steps.size() - 1).t == t;
      if (!again && !refining) {
        steps.add(new Step(t, distance));
      }
      return distance;
    }

    /** From here on there are no steps: only the crossing is refined. */
    @Override
    double crossing(final double before, final double after, final double side,
        final double x, final double y, final double z, final double dx, final double dy, final double dz) {
      refining = true;
      return super.crossing(before, after, side, x, y, z, dx, dy, dz);
    }

    @Override
    protected float SDF(final Point3D P) {
      return object.SDF(P);
    }

    @Override
    protected float distanceUpperBound(final Point3D P) {
      return object.distanceUpperBound(P);
    }

    @Override
    public Hit intersectionWith(final Ray other) {
      return rayMarching(other);
    }
  }
}
