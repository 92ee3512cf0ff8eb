/** The documents of the project keep their word: their examples compile and run, their links lead somewhere. */
package documentation;
