package models;

import java.util.SplittableRandom;

import primitives.Point3D;
import primitives.Vector3D;

/**
 * Random numbers for tests, the same in every run. The system property {@code test.seed} selects others;
 * {@code toString}, which belongs in the message of every failed assertion, gives the seed. The system property
 * {@code test.factor} multiplies the length of the longer random tests:
 * {@code ant test-single -Dtest.includes=models/SphereTest.java "-Dtest.jvmargs=-ea -Dtest.seed=7 -Dtest.factor=100"}.
 */
public final class RandomNumbers {

  private static final long SEED = Long.getLong("test.seed", 20181210);
  private static final int FACTOR = Integer.getInteger("test.factor", 1);

  private final SplittableRandom random;

  /**
   * The numbers of one test.
   *
   * @param test name of the test, so that different tests get different numbers
   */
  public RandomNumbers(final String test) {
    random = new SplittableRandom(SEED ^ (long) test.hashCode() << 32);
  }

  /**
   * How many times to try something.
   *
   * @param number number of trials in an everyday run
   * @return the number, times the factor asked for
   */
  public static int times(final int number) {
    return number * FACTOR;
  }

  /**
   * A number of an interval.
   *
   * @param low lower end
   * @param high upper end
   * @return the number
   */
  public double between(final double low, final double high) {
    return low + (high - low) * random.nextDouble();
  }

  /**
   * An index.
   *
   * @param count number of elements
   * @return 0 … count − 1
   */
  public int index(final int count) {
    return random.nextInt(count);
  }

  /**
   * A positive number whose order of magnitude is random: its exponent is drawn, not its value.
   *
   * @param lowExponent least exponent of 2
   * @param highExponent greatest exponent of 2
   * @return the number
   */
  public float magnitude(final double lowExponent, final double highExponent) {
    return (float) Math.pow(2, between(lowExponent, highExponent));
  }

  /**
   * A direction, evenly from the whole sphere.
   *
   * @return a vector of about unit length
   */
  public Vector3D direction() {
    while (true) {
      final double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1), length = Math.sqrt(x * x + y * y + z * z);
      if (length > 0.1 && length < 1) {
        return new Vector3D((float) (x / length), (float) (y / length), (float) (z / length));
      }
    }
  }

  /**
   * A point of a cube.
   *
   * @param centre its middle
   * @param half half the length of its edges
   * @return the point
   */
  public Point3D pointAbout(final Point3D centre, final double half) {
    return new Point3D((float) (centre.x + between(-half, half)), (float) (centre.y + between(-half, half)),
        (float) (centre.z + between(-half, half)));
  }

  @Override
  public String toString() {
    return "-Dtest.seed=" + SEED;
  }
}
