package models;

import static arguments.Arguments.notNull;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import primitives.Point3D;
import tracer.Hit;
import tracer.Ray;

/**
 * How a march along a ray went, step by step: sphere tracing by nothing but the signed distance of an object and the bound
 * of how far away it can be.
 *
 * <p>These are the steps of an object that makes its intersections from {@code rayMarching} alone. {@link Torus} and
 * {@link Ellipsoid} know longer steps that lead to the same place.
 *
 * @param steps the points where the distance was asked, in the order of asking; t can go back where a step was too long
 * @param limit t beyond which there can be nothing
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
    /** It came farther than the object can be. */
    PASSED,
    /** The distance was not a number. */
    UNDEFINED,
    /** It came to no end within the number of steps that it is allowed. */
    GIVEN_UP
  }

  /**
   * Copies the list.
   *
   * @param steps the points where the distance was asked, in the order of asking; t can go back where a step was too
   *     long
   * @param limit t beyond which there can be nothing
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
   * @return the march; empty if the object is not marched to, or if there is no ray
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

  /** Marches as the object would by its distance alone, and notes where it was asked. */
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

    /** The same place is asked for several reasons at the start. */
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

    /** From here on no step is made: where the surface was crossed is only told more exactly. */
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
    public Hit intersectionWith(final Ray asked) {
      return rayMarching(asked);
    }
  }
}
