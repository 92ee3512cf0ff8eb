package inspection;

/**
 * A formula of the assignment, evaluated.
 *
 * @param symbol the symbol that it defines
 * @param general the formula as in the assignment; empty for a given quantity
 * @param numbers the formula with numbers substituted; empty if there is nothing to compute
 * @param value the result
 */
public record Formula(String symbol, String general, String numbers, String value) {

  @Override
  public String toString() {
    return symbol + (general.isEmpty() ? "" : " = " + general) + (numbers.isEmpty() ? "" : " = " + numbers) + " = " + value;
  }
}
