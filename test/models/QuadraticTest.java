package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class QuadraticTest {

  /** (t − 3)(t − 5) = t² − 8 t + 15. */
  @Test
  void rootsComeInOrder() {
    assertEquals(3, Quadratic.smaller(1, 4, 15, 1));
    assertEquals(5, Quadratic.greater(1, 4, 15, 1));
    assertEquals(-5, Quadratic.smaller(1, -4, 15, 1));
    assertEquals(-3, Quadratic.greater(1, -4, 15, 1));
    assertEquals(-2, Quadratic.smaller(2, 0, -8, 4));
    assertEquals(2, Quadratic.greater(2, 0, -8, 4));
    assertEquals(0, Quadratic.smaller(1, 0, 0, 0));
    assertEquals(0, Quadratic.greater(1, 0, 0, 0));
  }

  /** t² − 2·10⁹ t + 1: the smaller root is 5·10⁻¹⁰ to all digits, where b − √D would be 0. */
  @Test
  void smallRootBesideALargeOneDoesNotCancel() {
    assertEquals(5e-10, Quadratic.smaller(1, 1e9, 1, Math.sqrt(1e18 - 1)));
    assertEquals(-5e-10, Quadratic.greater(1, -1e9, 1, Math.sqrt(1e18 - 1)));
  }

  @Test
  void firstPositiveLeavesOutWhatIsBehindOrNone() {
    assertEquals(3, Quadratic.firstPositive(3, 5));
    assertEquals(5, Quadratic.firstPositive(-3, 5));
    assertEquals(5, Quadratic.firstPositive(0, 5));
    assertEquals(Double.POSITIVE_INFINITY, Quadratic.firstPositive(-5, -3));
    assertEquals(Double.POSITIVE_INFINITY, Quadratic.firstPositive(-5, 0));
    assertEquals(Double.POSITIVE_INFINITY, Quadratic.firstPositive(Double.NaN, Double.NaN));
  }

  @Test
  void slabIsEnteredBeforeItIsLeft() {
    assertEquals(3, Slab.enter(-5, 1, 2));
    assertEquals(7, Slab.leave(-5, 1, 2));
    assertEquals(-3.5, Slab.enter(-5, -2, 2));
    assertEquals(-1.5, Slab.leave(-5, -2, 2));
  }

  @Test
  void slabHoldsParallelLinesInsideForEverAndThoseOutsideNever() {
    for (final double zero : new double[] {0.0, -0.0}) {
      assertEquals(Double.NEGATIVE_INFINITY, Slab.enter(2, zero, 2));
      assertEquals(Double.POSITIVE_INFINITY, Slab.leave(2, zero, 2));
      assertTrue(Double.isNaN(Slab.enter(-2.5, zero, 2)));
    }
  }

  @Test
  void sideOfASlabIsThatOfThePointUnlessRoundingHasEatenIt() {
    assertEquals(1, Slab.side(1.99, -5, 1, 2));
    assertEquals(-1, Slab.side(-2, -5, 1, 2));
    assertEquals(-1, Slab.side(0, -5, 1, 1e-20));
    assertEquals(-1, Slab.side(1e-16, -5, 1, 1e-20));
    assertEquals(1, Slab.side(-1e-16, 0, 1, 1e-20));
    assertEquals(-1, Slab.side(1e-16, 0, -1, 1e-20));
    assertEquals(2, Slab.within(3, 2));
    assertEquals(-2, Slab.within(-3, 2));
    assertEquals(1, Slab.within(1, 2));
  }
}
