package models;

import static arguments.Arguments.notNull;

import java.util.Optional;

import tracer.Hit;
import tracer.Ray;

/**
 * The barycentric coordinates of a point in a triangle: the weight of each vertex. None is negative, and their sum is 1.
 *
 * @param a of the first vertex
 * @param b of the second vertex
 * @param c of the third vertex
 */
public record Weights(double a, double b, double c) {

  /**
   * The weights by which the corners of a triangle, of a mesh too, count at a hit: those of its shading normal and its
   * texture coordinates.
   *
   * @param ray the ray, in the frame of the triangle
   * @param hit its hit there
   * @return the weights; empty unless a triangle was hit
   * @throws IllegalArgumentException if an argument is null
   */
  public static Optional<Weights> of(final Ray ray, final Hit hit) {
    notNull("ray", ray);
    return notNull("hit", hit).getObject() instanceof Triangle triangle
        ? Optional.of(triangle.weights(ray, triangle.distance(ray.startX(), ray.startY(), ray.startZ(),
            ray.directionX(), ray.directionY(), ray.directionZ()))) : Optional.empty();
  }

  /** The weights of three numbers that are proportional to them up to rounding. */
  static Weights proportionalTo(final double a, final double b, final double c) {
    final double x = Math.max(0, a), y = Math.max(0, b), z = Math.max(0, c), inverse = 1 / (x + y + z);
    return new Weights(x * inverse, y * inverse, z * inverse);
  }

  /** The weight of a vertex, 0, 1 or 2. */
  double of(final int vertex) {
    return vertex == 0 ? a : vertex == 1 ? b : c;
  }
}
