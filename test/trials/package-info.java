/** Shared code of tests with random numbers. */
package trials;
