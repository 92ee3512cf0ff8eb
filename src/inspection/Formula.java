package inspection;

/**
 * A formula of the assignment and what it gives for some numbers.
 *
 * @param symbol what it defines
 * @param general the formula as the assignment has it
 * @param numbers the same with the numbers in it
 * @param value what comes out
 */
public record Formula(String symbol, String general, String numbers, String value) {

  @Override
  public String toString() {
    return symbol + " = " + general + " = " + numbers + " = " + value;
  }
}
