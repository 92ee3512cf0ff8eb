/**
 * The window: shows pictures while they are rendered, and what {@link inspection} has to say about their pixels.
 *
 * <p>It is found by the command line as the service {@link upnatray.Viewer}; no other package knows it, and nothing of it is
 * loaded where there is no window. A program of one's own shows a scene by {@link window.RenderWindow#show}.
 */
package window;
