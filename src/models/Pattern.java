package models;

import tracer.Hit;

/** Whether a class overrides {@link Object3D#getColorAt}. */
final class Pattern {

  /** For each class; if {@link Object3D#isTextured} is declared by the same class, that decides instead. */
  private static final ClassValue<Boolean> OF_ITS_OWN = new ClassValue<>() {
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

  static boolean isOn(final Class<?> type) {
    return OF_ITS_OWN.get(type);
  }
}
