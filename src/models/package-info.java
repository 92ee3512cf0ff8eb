/**
 * Objects that rays can hit: shapes, meshes, groups, and transformed objects. The contract of an intersection is in
 * {@link models.Object3D}; frames, units and signs are in {@link primitives}.
 *
 * <p><a href="Sphere.html"><img src="doc-files/Sphere.png" width="160" height="120" alt="Sphere"></a>
 * <a href="Plane.html"><img src="doc-files/Plane.png" width="160" height="120" alt="Plane"></a>
 * <a href="Triangle.html"><img src="doc-files/Triangle.png" width="160" height="120" alt="Triangle"></a>
 * <a href="Box.html"><img src="doc-files/Box.png" width="160" height="120" alt="Box"></a>
 * <a href="Cylinder.html"><img src="doc-files/Cylinder.png" width="160" height="120" alt="Cylinder"></a>
 * <a href="Capsule.html"><img src="doc-files/Capsule.png" width="160" height="120" alt="Capsule"></a>
 * <a href="Torus.html"><img src="doc-files/Torus.png" width="160" height="120" alt="Torus"></a>
 * <a href="Ellipsoid.html"><img src="doc-files/Ellipsoid.png" width="160" height="120" alt="Ellipsoid"></a>
 * <a href="Egg.html"><img src="doc-files/Egg.png" width="160" height="120" alt="Egg"></a>
 * <a href="TruncatedCone.html"><img src="doc-files/TruncatedCone.png" width="160" height="120" alt="Truncated cone"></a>
 *
 * <h2>How to add a shape</h2>
 * <p>Extend {@link models.Object3D}, pass the colour to its constructor, and implement {@code intersectionWith}: it returns
 * the hit of smallest t &gt; 0 with the outward unit normal, or {@link tracer.Hit#NOHIT}. That is all; such an object works
 * in groups, transformations and images. Two things make it better:
 * <ul>
 * <li>{@code getBoundingBox}, so that rays that miss the box are not tested against the object;</li>
 * <li>computing in double where numbers can cancel, such as in a discriminant.</li>
 * </ul>
 * <p>The laws that every shape must obey are an interface of the tests; the test of a new shape implements it. As an
 * example, an infinite floor:
 *
 * <pre>{@code
 * public class Floor extends Object3D {
 *   private final float height;
 *
 *   public Floor(float height, Color color) {
 *     super(color);
 *     this.height = height;
 *   }
 *
 *   public Hit intersectionWith(Ray ray) {
 *     float t = (height - ray.getStartingPoint().y) / ray.getDirection().y;
 *     boolean hits = t > 0 && t < Float.POSITIVE_INFINITY;
 *     return hits ? new Hit(t, ray.pointAtParameter(t), new Vector3D(0, 1, 0), this) : Hit.NOHIT;
 *   }
 * }
 * }</pre>
 *
 * <h2>Constructors that the assignment describes in words</h2>
 * <ul>
 * <li>{@code Sphere(C, r, color)}, {@code Plane(P, n, color)}, {@code Triangle(A, B, C, color)}</li>
 * <li>{@code Cylinder(P, u, r, l, color)} and {@code Capsule(P, u, r, l, color)}: P is the middle of the axis</li>
 * <li>{@code Box(C, i, aux, w, h, d, color)} and {@code Ellipsoid(C, i, aux, Rx, Ry, Rz, color)}: k = i × aux
 *     normalised, j = k × i</li>
 * <li>{@code Torus(C, axis, R, r, color)}</li>
 * </ul>
 *
 * <p>Two shapes are the course's, not the assignment's: {@code Egg(C, axis, a, b, w, color)} and
 * {@code TruncatedCone(P, u, rA, rB, l, color)}, P being the middle of the axis.
 */
package models;
