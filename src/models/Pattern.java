package models;

import tracer.Hit;

/** Classes whose objects are not of one colour, as they override {@link Object3D#getColorAt}. */
final class Pattern {

  /** Whether a class is one; not if the override comes with one of {@link Object3D#isTextured}, which then decides. */
  private static final ClassValue<Boolean> OVERRIDDEN = new ClassValue<>() {
    @Override
    protected Boolean computeValue(final Class<?> type) {
      try {
        final Class<?> declaring = type.getMethod("getColorAt", Hit.class).getDeclaringClass();
        return !OverridingShape.declares(declaring, "isTextured");
      } catch (final NoSuchMethodException impossible) {
        throw new AssertionError(impossible);
      }
    }
  };

  private Pattern() {
  }

  /** Whether objects of a class have a pattern. */
  static boolean isOn(final Class<?> type) {
    return OVERRIDDEN.get(type);
  }
}
