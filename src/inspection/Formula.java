package inspection;

/**
 * A formula of the assignment and what it gives for some numbers.
 *
 * @param symbol what it defines
 * @param general the formula as the assignment has it; empty for a number that is given
 * @param numbers the same with the numbers in it; empty if there is nothing to compute
 * @param value what comes out
 */
public record Formula(String symbol, String general, String numbers, String value) {

  @Override
  public String toString() {
    return symbol + (general.isEmpty() ? "" : " = " + general) + (numbers.isEmpty() ? "" : " = " + numbers) + " = " + value;
  }
}
