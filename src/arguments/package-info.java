/**
 * The checks that every public constructor and method makes on its arguments, with their messages in
 * English ({@code messages.properties}) and Spanish ({@code messages_es.properties}).
 */
package arguments;
