/**
 * How a scene becomes pixels. A {@link rendering.TileRenderer} traces the rays of a camera in tiles shared out among
 * threads,
 * as {@link rendering.RenderSettings} say; a {@link rendering.Shading} turns each hit into a colour.
 */
package rendering;
