/**
 * What is handed in: {@code upnatray0.zip}, as the assignment asks for it, once its rules are kept. The target
 * {@code entrega} of {@code ant/handin.xml} calls it; the program does not know it.
 */
package handin;
