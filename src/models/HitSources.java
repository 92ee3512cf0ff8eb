package models;

import java.util.Arrays;

/**
 * What the hits of a tile come from, as small numbers: an object of the group, by its place in the order of adding, what of
 * it is painted, and the colour of that. Number 0 is for pixels without a hit.
 */
final class HitSources {

  /** What the colour of a source depends on; UNKNOWN until the first pixel is painted. */
  private enum Colouring { UNKNOWN, NOTHING, PART, PLACE }

  private static final int ROOM = 64;

  private int[] orders = new int[ROOM];
  private Object3D[] owners = new Object3D[ROOM];
  private Object3D[] painted = new Object3D[ROOM];
  private Colouring[] colourings = new Colouring[ROOM];
  private int[] colours = new int[ROOM];
  private int count;

  private Class<?> lastClass;
  private boolean lastIsPatterned;

  HitSources() {
    clear();
  }

  /** Forgets all sources. */
  void clear() {
    Arrays.fill(owners, 0, count, null);
    Arrays.fill(painted, 0, count, null);
    orders[0] = -1;
    count = 1;
  }

  /** The number of a source, a new one unless it is the last one. */
  int number(final int order, final Object3D owner, final Object3D itsPainted) {
    final int last = count - 1;
    if (orders[last] == order && owners[last] == owner && painted[last] == itsPainted) {
      return last;
    }
    if (count == orders.length) {
      grow();
    }
    orders[count] = order;
    owners[count] = owner;
    painted[count] = itsPainted;
    colourings[count] = Colouring.UNKNOWN;
    return count++;
  }

  private void grow() {
    final int room = 2 * count;
    orders = Arrays.copyOf(orders, room);
    owners = Arrays.copyOf(owners, room);
    painted = Arrays.copyOf(painted, room);
    colourings = Arrays.copyOf(colourings, room);
    colours = Arrays.copyOf(colours, room);
  }

  /** The place of the object in the order of adding; −1 for none. */
  int order(final int number) {
    return orders[number];
  }

  Object3D owner(final int number) {
    return owners[number];
  }

  Object3D painted(final int number) {
    return painted[number];
  }

  /** Whether the colour depends on where the object is hit. */
  boolean isPatterned(final int number) {
    return colouring(number) == Colouring.PLACE;
  }

  /** Whether the colour is always the same. */
  boolean hasOneColor(final int number) {
    return colouring(number) == Colouring.NOTHING;
  }

  /** The colour of a part of a source that is not patterned, as sRGB with alpha. */
  int argb(final int number, final int part) {
    return colouring(number) == Colouring.NOTHING ? colours[number] : painted[number].argb(part);
  }

  private Colouring colouring(final int number) {
    if (colourings[number] == Colouring.UNKNOWN) {
      final Object3D object = painted[number];
      colourings[number] = isPatterned(object) ? Colouring.PLACE
          : object.hasPartColors() ? Colouring.PART : Colouring.NOTHING;
      colours[number] = colourings[number] == Colouring.NOTHING ? object.argb(0) : 0;
    }
    return colourings[number];
  }

  /** Remembers the last class: most of a scene's objects have the same. */
  private boolean isPatterned(final Object3D object) {
    if (object.getClass() != lastClass) {
      lastClass = object.getClass();
      lastIsPatterned = Pattern.isOn(lastClass);
    }
    return lastIsPatterned || object.isTextured();
  }
}
