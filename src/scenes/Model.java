package scenes;

import models.Object3D;

/** A model of a scene file: a shape about the origin of its own frame, without place and appearance. */
interface Model {

  /** The shape where a rigid placement takes it. */
  Object3D at(Placement placement, Appearance look);

  /** An object of the scene: built where it is to be if it keeps its form, transformed if it does not. */
  default Object3D placed(final Placement placement, final Appearance look) {
    return placement.isRigid() ? at(placement, look) : placement.applied(at(Placement.NONE, look));
  }
}
