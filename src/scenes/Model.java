package scenes;

import models.Appearance;
import models.Object3D;

/** A model of a scene file: a shape about the origin of its own frame, without place and appearance. */
interface Model {

  /** Key of the message that says why the model cannot have a texture; null if it can. */
  default String textureFault() {
    return "textureNowhere";
  }

  /** Whether the model has materials of its own; then its appearance is null. */
  default boolean hasMaterials() {
    return false;
  }

  /** Reports problems of the model's place in the scene. */
  default void check(final Placement placement, final int offset) {
    // Shapes check their own numbers.
  }

  /** The shape, placed by a rigid placement. */
  Object3D at(Placement placement, Appearance appearance);

  /** An object of the scene: constructed in place if the placement is rigid, else transformed. */
  default Object3D placed(final Placement placement, final Appearance appearance) {
    return placement.isRigid() ? at(placement, appearance) : placement.applied(at(Placement.NONE, appearance));
  }
}
