package inspection;

/** Something about an object's answer to a ray that its contract does not allow, or that is often a mistake. */
public enum ContractViolation {
  /** It answered null instead of {@link tracer.Hit#NOHIT}. */
  NULL_HIT,
  /** It threw an exception. */
  EXCEPTION,
  /** Asked twice, it gave two answers: it keeps something from one question to the next. */
  UNSTEADY,
  /** The point of the hit is not R + t v. */
  POINT_OFF_RAY,
  /** The point of the hit lies outside the object's bounding box. */
  POINT_OUTSIDE_BOX,
  /** The ray does not cross the bounding box, so that a group never asks the object. */
  BOX_PASSED_BY,
  /** The bounding box is null. */
  NULL_BOX,
  /**
   * The ray comes from outside and the normal points away from where it comes: it looks inward, or the object is not
   * closed. Not told of planes, triangles and meshes, for which this is nothing special.
   */
  NORMAL_INWARD
}
