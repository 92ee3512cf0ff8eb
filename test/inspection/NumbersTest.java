package inspection;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class NumbersTest {

  @Test
  void floatsHaveAPowerOfTenOnlyWhereItIsShorter() {
    assertEquals("0", Numbers.text(-0f));
    assertEquals("12", Numbers.text(12f));
    assertEquals("9999999", Numbers.text(9999999f));
    assertEquals("1E7", Numbers.text(1e7f));
    assertEquals("0.001", Numbers.text(1e-3f));
    assertEquals("0.00012345", Numbers.text(1.2345e-4f));
    assertEquals("1E-5", Numbers.text(1e-5f));
    assertEquals("1E-40", Numbers.text(1e-40f));
    assertEquals("1.4E-45", Numbers.text(Float.MIN_VALUE));
  }
}
