/** The documents of the project are right: their examples compile and run, and their links lead somewhere. */
package documentation;
