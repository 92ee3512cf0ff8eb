package inspection;

/** A violation of the contract of {@link models.Object3D#intersectionWith} by an object, or a likely mistake. */
public enum ContractViolation {
  /** It returned null instead of {@link tracer.Hit#NOHIT}. */
  NULL_HIT,
  /** It threw an exception. */
  EXCEPTION,
  /** Two calls with the same ray returned different hits: the object keeps state between calls. */
  INCONSISTENT,
  /** The point of the hit is not R + t v. */
  POINT_OFF_RAY,
  /** The point of the hit lies outside the object's bounding box. */
  POINT_OUTSIDE_BOX,
  /** The ray misses the bounding box, so a group never tests the object. */
  BOX_MISSED_BY_RAY,
  /** The bounding box is null. */
  NULL_BOX,
  /**
   * The ray starts outside the box and the normal points along it: the normal points inward, or the object is not closed.
   * Not reported for planes, triangles and meshes, where this is normal.
   */
  NORMAL_INWARD
}
