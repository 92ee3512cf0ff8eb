package models;

import java.awt.Color;

import primitives.BoundingBox;
import tracer.Hit;
import tracer.Ray;

/**
 * A user-written subclass of a shape of the library with an {@link Object3D#intersectionWith} of its own: only that
 * method is called, and not the formulas that it inherits.
 */
final class OverridingShape extends Object3D {

  /** For each class, whether it overrides the intersection but not the library's formulas for it. */
  private static final ClassValue<Boolean> OVERRIDES = new ClassValue<>() {
    @Override
    protected Boolean computeValue(final Class<?> type) {
      Class<?> declaring = type;
      while (declaring != Object3D.class && !declares(declaring, "intersectionWith")) {
        declaring = declaring.getSuperclass();
      }
      if (declares(declaring, "distance") || declares(declaring, "closestHits")) {
        return false;
      }
      while (declaring != Object3D.class && !declares(declaring, "distance") && !declares(declaring, "closestHits")) {
        declaring = declaring.getSuperclass();
      }
      return declaring != Object3D.class;
    }
  };

  private final Object3D shape;

  private OverridingShape(final Object3D shape) {
    super();
    this.shape = shape;
  }

  /** Whether a class itself, not one that it extends, declares a method of a name. */
  static boolean declares(final Class<?> type, final String name) {
    for (final var method : type.getDeclaredMethods()) {
      if (method.getName().equals(name)) {
        return true;
      }
    }
    return false;
  }

  /** The object to be tested: the given one, wrapped if it overrides the intersection of a shape of the library. */
  static Object3D asked(final Object3D object) {
    return OVERRIDES.get(object.getClass()) ? new OverridingShape(object) : object;
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return shape.intersectionWith(ray);
  }

  @Override
  public Color getColor() {
    return shape.getColor();
  }

  @Override
  public BoundingBox getBoundingBox() {
    return shape.getBoundingBox();
  }

  @Override
  public String toString() {
    return shape.toString();
  }
}
