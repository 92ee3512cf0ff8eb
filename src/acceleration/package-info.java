/**
 * The acceleration structure: boxes and rays only, no shape is known to it.
 *
 * <p>A {@link acceleration.Bvh} is a tree of boxes over the primitives of a group or a mesh, built by the surface area
 * heuristic ({@link acceleration.BvhBuilder}). It is asked with one ray, or with a {@link acceleration.RayTile} of up to
 * 32 × 32 rays at once, whose {@link acceleration.TileFrustum} finds which boxes they may cross. Leaves are handed to the
 * owner, who intersects what lies in them and returns how far away a primitive may be and still matter. The promise: the
 * same closest primitive as asking all of them, in any order of asking; the tree only leaves out what cannot be hit.
 *
 * <p>Papers: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007 (building); Reshetov, Soupikov and
 * Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005 (tiles); Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013
 * (boxes without holes).
 */
package acceleration;
