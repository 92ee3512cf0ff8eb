/**
 * How a scene becomes pixels. {@link rendering.PixelLoop}, to be read first, is the loop of the assignment; a
 * {@link rendering.TileRenderer} gives the same pixels faster, in tiles shared out among threads. A
 * {@link rendering.PixelWriter} receives the hit of each pixel: it makes a colour by a {@link rendering.Shading}, or the
 * number of a {@link rendering.NumberPass}. {@link rendering.RenderSettings} select all of it.
 *
 * <p>{@link rendering.Illumination} is the shading of a lit scene: at each hit the lights that nothing blocks, then the
 * ideally reflected and refracted rays, whose hits are shaded in the same way. Its numbers are those of
 * {@link radiometry}; all of it is computed in double. A ray leaves a surface by the error bound of the hit
 * ({@link tracer.Hit#leave}), never by a constant in scene units.
 *
 * <p>What a {@link rendering.RenderPass} shows of the same scene: its colour, normals, depth, objects, cost and light.
 *
 * <p><img src="doc-files/colour.png" width="160" alt="Colour">
 * <img src="doc-files/normals.png" width="160" alt="Normals">
 * <img src="doc-files/depth.png" width="160" alt="Depth">
 * <img src="doc-files/object.png" width="160" alt="Objects">
 * <img src="doc-files/cost.png" width="160" alt="Cost">
 * <img src="doc-files/light.png" width="160" alt="Light">
 */
package rendering;
