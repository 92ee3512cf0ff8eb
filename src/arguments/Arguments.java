package arguments;

import javax.vecmath.Tuple3f;

/**
 * The one place where the arguments of public constructors and methods are checked.
 *
 * <p>Each check returns the value it was given, for use in an assignment ({@code this.r = positive("r", r)}), or throws
 * an {@link IllegalArgumentException} whose message names the argument and its value, in the language of the default
 * locale (English, Spanish).
 */
public final class Arguments {

  /**
   * Sine of the angle below which two directions count as parallel. A direction of floats is uncertain by half an ulp,
   * 2<sup>-24</sup>, in each component; this is eight times that.
   */
  private static final double PARALLEL = 0x1p-21;

  private Arguments() {
  }

  /**
   * Checks that an argument is not null.
   *
   * @param <T> its type
   * @param name name of the argument
   * @param value its value
   * @return the value
   * @throws IllegalArgumentException if the value is null
   */
  public static <T> T notNull(final String name, final T value) {
    if (value == null) {
      throw wrong("null", name);
    }
    return value;
  }

  /**
   * Checks that a number is neither infinite nor NaN.
   *
   * @param name name of the argument
   * @param value its value
   * @return the value
   * @throws IllegalArgumentException if the value is infinite or NaN
   */
  public static float finite(final String name, final float value) {
    if (!Float.isFinite(value)) {
      throw wrong("finite", name, value);
    }
    return value;
  }

  /**
   * Checks a length or a size: greater than 0 and finite.
   *
   * @param name name of the argument
   * @param value its value
   * @return the value
   * @throws IllegalArgumentException if the value is not positive, infinite or NaN
   */
  public static float positive(final String name, final float value) {
    if (!(value > 0 && value < Float.POSITIVE_INFINITY)) {
      throw wrong("positive", name, value);
    }
    return value;
  }

  /**
   * Checks that a number is greater than another argument.
   *
   * @param name name of the argument
   * @param value its value
   * @param otherName name of the other argument
   * @param other its value, excluded
   * @return the value
   * @throws IllegalArgumentException if the value is not greater than the other, or if one of them is NaN
   */
  public static float greater(final String name, final float value, final String otherName, final float other) {
    if (!(value > other)) {
      throw wrong("greater", name, value, otherName, other);
    }
    return value;
  }

  /**
   * Checks a count: at least 1.
   *
   * @param name name of the argument
   * @param value its value
   * @return the value
   * @throws IllegalArgumentException if the value is less than 1
   */
  public static int positive(final String name, final int value) {
    if (value < 1) {
      throw wrong("count", name, value);
    }
    return value;
  }

  /**
   * Checks that a number lies in an open interval.
   *
   * @param name name of the argument
   * @param low lower end, excluded
   * @param high upper end, excluded
   * @param value its value
   * @return the value
   * @throws IllegalArgumentException if the value is not strictly between the ends, or is NaN
   */
  public static float between(final String name, final float low, final float high, final float value) {
    if (!(value > low && value < high)) {
      throw wrong("between", name, value, low, high);
    }
    return value;
  }

  /**
   * Checks that a number lies in a closed interval.
   *
   * @param name name of the argument
   * @param low lower end, included
   * @param high upper end, included
   * @param value its value
   * @return the value
   * @throws IllegalArgumentException if the value lies outside, or is NaN
   */
  public static float within(final String name, final float low, final float high, final float value) {
    if (!(value >= low && value <= high)) {
      throw wrong("within", name, value, low, high);
    }
    return value;
  }

  /**
   * Checks that a number in double lies in a closed interval.
   *
   * @param name name of the argument
   * @param low lower end, included
   * @param high upper end, included
   * @param value its value
   * @return the value
   * @throws IllegalArgumentException if the value lies outside, or is NaN
   */
  public static double within(final String name, final double low, final double high, final double value) {
    if (!(value >= low && value <= high)) {
      throw wrong("within", name, value, low, high);
    }
    return value;
  }

  /**
   * Checks a quantity: at least 0 and finite.
   *
   * @param name name of the argument
   * @param value its value
   * @return the value
   * @throws IllegalArgumentException if the value is negative, infinite or NaN
   */
  public static float notNegative(final String name, final float value) {
    if (!(value >= 0 && value < Float.POSITIVE_INFINITY)) {
      throw wrong("notNegative", name, value);
    }
    return value;
  }

  /**
   * Checks a quantity in double: at least 0 and finite.
   *
   * @param name name of the argument
   * @param value its value
   * @return the value
   * @throws IllegalArgumentException if the value is negative, infinite or NaN
   */
  public static double notNegative(final String name, final double value) {
    if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
      throw wrong("notNegative", name, value);
    }
    return value;
  }

  /**
   * Checks that an index is one of {@code 0 … count - 1}.
   *
   * @param name name of the argument
   * @param count number of elements
   * @param value its value
   * @return the value
   * @throws IllegalArgumentException if the value is negative or not less than the count
   */
  public static int index(final String name, final int count, final int value) {
    if (value < 0 || value >= count) {
      throw wrong("index", name, value, count - 1);
    }
    return value;
  }

  /**
   * Checks a point or a vector: not null, and all coordinates finite.
   *
   * @param <T> its type
   * @param name name of the argument
   * @param tuple its value
   * @return the value, the very object that was given
   * @throws IllegalArgumentException if it is null or a coordinate is infinite or NaN
   */
  public static <T extends Tuple3f> T finite(final String name, final T tuple) {
    notNull(name, tuple);
    if (!(Float.isFinite(tuple.x) && Float.isFinite(tuple.y) && Float.isFinite(tuple.z))) {
      throw wrong("finite", name, tuple);
    }
    return tuple;
  }

  /**
   * Checks a direction: a finite vector other than zero.
   *
   * @param <T> its type
   * @param name name of the argument
   * @param vector its value, of any length
   * @return the value, the very object that was given
   * @throws IllegalArgumentException if it is null or zero or a component is infinite or NaN
   */
  public static <T extends Tuple3f> T direction(final String name, final T vector) {
    finite(name, vector);
    if (vector.x == 0 && vector.y == 0 && vector.z == 0) {
      throw wrong("zero", name, vector);
    }
    return vector;
  }

  /**
   * Checks that two directions span a plane: neither is zero, and they are not parallel up to the rounding
   * of floats.
   *
   * @param name name of the argument at fault if they are parallel
   * @param vector its value
   * @param otherName name of the direction that it must differ from
   * @param other that direction
   * @throws IllegalArgumentException if one of them is not a direction, or if they are parallel
   */
  public static void notParallel(final String name, final Tuple3f vector, final String otherName, final Tuple3f other) {
    direction(name, vector);
    direction(otherName, other);
    final double ux = vector.x, uy = vector.y, uz = vector.z, vx = other.x, vy = other.y, vz = other.z;
    final double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    final double lengths = Math.sqrt((ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz));
    if (!(Math.sqrt(x * x + y * y + z * z) > PARALLEL * lengths)) {
      throw wrong("parallel", name, vector, otherName, other);
    }
  }

  /**
   * The exception for an argument that none of the checks above covers.
   *
   * @param key key of the message in the bundle {@code arguments.messages}
   * @param parts parts of the message: the argument, its value, and so on
   * @return the exception, to be thrown
   */
  public static IllegalArgumentException wrong(final String key, final Object... parts) {
    return new IllegalArgumentException(message(key, parts));
  }

  /**
   * The exception for a call in the wrong state.
   *
   * @param key key of the message in the bundle {@code arguments.messages}
   * @param parts parts of the message
   * @return the exception, to be thrown
   */
  public static IllegalStateException wrongState(final String key, final Object... parts) {
    return new IllegalStateException(message(key, parts));
  }

  private static String message(final String key, final Object... parts) {
    return Messages.text("arguments." + key, parts);
  }
}
