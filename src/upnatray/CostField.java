package upnatray;

import java.awt.Color;

import models.Cost;
import models.Object3D;
import tracer.Hit;
import tracer.Ray;

/** An object that every ray meets at the distance 1 + c, where c is what the ray costs in a scene. */
final class CostField extends Object3D {

  private final Object3D scene;

  CostField(final Object3D scene) {
    super(Color.BLACK);
    this.scene = scene;
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    return ray == Ray.NORAY ? Hit.NOHIT
        : new Hit(1f + Cost.of(scene, ray), ray.getStartingPoint(), ray.getDirection(), this);
  }
}
