package upnatray;

import java.awt.Color;

import models.Object3D;
import primitives.BoundingBox;
import tracer.Hit;
import tracer.Ray;

/** An object of a scene in a colour that tells it from the others, whatever it is made of. */
final class TaggedObject extends Object3D {

  /** Part of the colour circle between one object and the next: neighbours differ, and it takes long to come round. */
  private static final float GOLDEN_RATIO = 0.618034f;

  private final Object3D object;

  TaggedObject(final Object3D object, final int number) {
    super(color(number));
    this.object = object;
  }

  static Color color(final int number) {
    return Color.getHSBColor(number * GOLDEN_RATIO, 0.45f + 0.1f * (number % 5), 0.95f - 0.12f * (number % 4));
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    final Hit hit = object.intersectionWith(ray);
    return hit == null || !hit.hits() ? hit : Hit.of(hit.getT(), hit.pointX(), hit.pointY(), hit.pointZ(),
        hit.normalX(), hit.normalY(), hit.normalZ(), this);
  }

  @Override
  public BoundingBox getBoundingBox() {
    return object.getBoundingBox();
  }
}
