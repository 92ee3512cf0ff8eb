/**
 * The window: shows pictures while they are rendered, and what {@link inspection} reports about their pixels.
 *
 * <p>The command line finds it as the service {@link upnatray.Viewer}. No other package depends on it, and none of it is
 * loaded unless a window is opened. A program shows its own scene with {@link window.RenderWindow#show}.
 */
package window;
