package upnatray;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;

import models.Object3D;
import tracer.Hit;
import tracer.Ray;

/** A group as the assignment describes it, which tests all its objects: the oracle of everything that culls objects. */
final class LinearGroup extends Object3D {

  private final List<Object3D> objects = new ArrayList<>();

  LinearGroup() {
    super(Color.BLACK);
  }

  void addObject(final Object3D object) {
    objects.add(object);
  }

  @Override
  public Hit intersectionWith(final Ray ray) {
    Hit closest = Hit.NOHIT;
    for (final Object3D object : objects) {
      final Hit hit = object.intersectionWith(ray);
      closest = hit.isCloser(closest) ? hit : closest;
    }
    return closest;
  }
}
