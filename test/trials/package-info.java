/** What tests with random numbers share. */
package trials;
