package scenes;

import models.Appearance;
import models.Object3D;

/** A model of a scene file: a shape about the origin of its own frame, without place and appearance. */
interface Model {

  /** Key of the message why no texture can be put on the model; null if one can. */
  default String textureFault() {
    return "textureNowhere";
  }

  /** Whether the model brings materials of its own; then it is placed with null for its appearance. */
  default boolean hasMaterials() {
    return false;
  }

  /** Reports what is wrong with the place of the model in the scene, if anything is. */
  default void check(final Placement placement, final int offset) {
    // Shapes check their own numbers.
  }

  /** The shape where a rigid placement takes it. */
  Object3D at(Placement placement, Appearance appearance);

  /** An object of the scene: built where it is to be if it keeps its form, transformed if it does not. */
  default Object3D placed(final Placement placement, final Appearance appearance) {
    return placement.isRigid() ? at(placement, appearance) : placement.applied(at(Placement.NONE, appearance));
  }
}
