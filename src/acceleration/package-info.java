/**
 * The acceleration structure: it knows boxes and rays only, and no shape.
 *
 * <p>A {@link acceleration.Bvh} is a tree of boxes over the primitives of a group or a mesh, built by the surface area
 * heuristic ({@link acceleration.BvhBuilder}). It is traversed with one ray, or with a {@link acceleration.RayTile} of up
 * to 32 × 32 rays at once, whose {@link acceleration.TileFrustum} finds which boxes they may hit. Leaves are passed to
 * the owner, which intersects their primitives and returns the distance up to which primitives still matter. The result
 * is the same closest primitive as by testing all of them, in any order; the tree only culls primitives that cannot be
 * hit.
 *
 * <p>Papers: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007 (building); Reshetov, Soupikov and
 * Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005 (tiles); Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013
 * (boxes without holes).
 */
package acceleration;
