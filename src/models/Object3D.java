package models;

import static arguments.Arguments.notNull;
import static arguments.Arguments.wrongState;

import java.awt.Color;
import java.util.List;

import acceleration.RayTile;
import acceleration.TileWindow;
import materials.Material;
import materials.Texture;
import primitives.BoundingBox;
import tracer.Hit;
import tracer.Ray;

/**
 * An object that rays can hit, and its colour or material.
 *
 * <p>A new kind of object extends this class and implements {@link #intersectionWith}, nothing else; if it is bounded it
 * should also override {@link #getBoundingBox}, so that it is not tested against rays that miss its box. The contract of
 * an intersection, the same for all shapes:
 * <ul>
 * <li>t is the smallest t &gt; 0 at which the ray hits the surface, the distance from its start in scene units; from the
 *     inside of a closed object that is its far wall. A ray that starts exactly on the surface may or may not hit it
 *     there; a tangent ray may hit or miss;</li>
 * <li>the normal is of unit length and belongs to the surface: outward, never turned towards the ray;</li>
 * <li>if there is no such t the result is {@link Hit#NOHIT}, as it always is for {@link Ray#NORAY};</li>
 * <li>the object is not changed, so that several threads can query it at once. Between two pictures it may change, its box
 *     too: a picture shows it as it is when its {@code synthesis} begins, and it must not change before that ends.</li>
 * </ul>
 *
 * <p>The shapes of this package are faster because they override three package-private methods: {@link #distance}, a
 * formula for t alone; {@link #hitAt}, which makes the hit once the closest t is known; and {@link #closestHits}, for all
 * rays of a tile at once. Each has a default that calls {@link #intersectionWith}.
 */
public abstract class Object3D {

  /** Factor of a limit where distances have float accuracy only: a hit at the limit must not count as nearer. */
  private static final double FLOAT_LIMIT = 1 - 0x1p-21;

  private final Color color;
  private final Material material;

  /**
   * An object of one colour.
   *
   * @param color its colour, perhaps partly transparent (alpha goes into the picture as it is)
   * @throws IllegalArgumentException if the colour is null
   */
  protected Object3D(final Color color) {
    this(Appearance.of(color));
  }

  /**
   * An object of a material. Where there is no illumination, it has the {@linkplain Material#getColor colour} of the
   * material.
   *
   * @param material its material
   * @throws IllegalArgumentException if the material is null
   */
  protected Object3D(final Material material) {
    this(Appearance.of(material));
  }

  /**
   * An object of a colour where there is no illumination, and of a material where there is.
   *
   * @param color its colour
   * @param material its material
   * @throws IllegalArgumentException if an argument is null
   */
  protected Object3D(final Color color, final Material material) {
    this(new Appearance(notNull("color", color), notNull("material", material)));
  }

  /** An object without a colour, whose parts have colours of their own. */
  Object3D() {
    this(Appearance.NONE);
  }

  /** An object of an appearance that has been checked. */
  Object3D(final Appearance appearance) {
    this.color = appearance.color();
    this.material = appearance.material();
  }

  /**
   * Colour of the object.
   *
   * @return the colour; null for a group and for a mesh of many colours
   */
  public Color getColor() {
    return color;
  }

  /**
   * Material of the object.
   *
   * @return the material; null if it has none, as a group: then the object is matte, of its colour at the hit
   */
  public Material getMaterial() {
    return material;
  }

  /**
   * A box that contains the object. The default contains all of space, so that every ray hits it.
   *
   * @return the box; no hit lies outside
   */
  public BoundingBox getBoundingBox() {
    return BoundingBox.UNBOUNDED;
  }

  /**
   * The first hit of a ray with the object.
   *
   * @param ray the ray; {@link Ray#NORAY} hits nothing
   * @return the intersection of smallest t &gt; 0, or {@link Hit#NOHIT}
   * @throws IllegalArgumentException if the ray is null
   */
  public abstract Hit intersectionWith(Ray ray);

  /**
   * The colour to be painted at a hit of this object. Override it for a pattern.
   *
   * @param hit the hit, whose object is this one
   * @return the colour; by default {@link #getColor()}
   * @throws IllegalArgumentException if the hit is null
   */
  public Color getColorAt(final Hit hit) {
    notNull("hit", hit);
    return getColor();
  }

  /**
   * The arguments with which a constructor of its class recreates the object: points, vectors, numbers, objects and the
   * colour, in the order of the parameters. The inspector can write tests for hits of a class that returns them.
   *
   * @return the arguments; empty, the default, if they are not known
   */
  public List<Object> constructorArguments() {
    return List.of();
  }

  /** The last argument of the constructor: what the object was made of, a material or a colour. */
  Object colourOrMaterial() {
    return material == null ? color : material;
  }

  /**
   * The objects that this one consists of: those of a group, or the one that a transformation transforms.
   *
   * @return an immutable list; empty, the default, for a shape
   */
  public List<Object3D> parts() {
    return List.of();
  }

  /**
   * A ray in the frame of the {@link #parts()}.
   *
   * @param ray a ray in the frame of this object
   * @return the ray in the frame of the parts, its direction of unit length there; by default the same
   * @throws IllegalArgumentException if the ray is null
   */
  public Ray rayToParts(final Ray ray) {
    return notNull("ray", ray);
  }

  /**
   * A hit of one of the {@link #parts()} as a hit of this object.
   *
   * @param ray a ray in the frame of this object
   * @param hit what it hits in the frame of the parts
   * @return the hit in the frame of this object; by default the same
   * @throws IllegalArgumentException if an argument is null
   */
  public Hit hitFromParts(final Ray ray, final Hit hit) {
    notNull("ray", ray);
    return notNull("hit", hit);
  }

  /**
   * Distance of the first hit of a ray, given as six numbers so that nothing needs to be allocated.
   *
   * @return the smallest t &gt; 0; infinity if none, also for a ray of NaN; NaN, the default, from an object
   *     without such a formula, for which {@link #intersectionWith} is to be called
   */
  double distance(final double x, final double y, final double z, final double dx, final double dy, final double dz) {
    return Double.NaN;
  }

  /**
   * The hit at a distance that is known already.
   *
   * @param ray the ray
   * @param t what {@link #distance} or {@link #closestHits} found for it
   * @param part which part of the object was hit, as {@link #closestHits} found it; 0 for an object without parts
   */
  Hit hitAt(final Ray ray, final double t, final int part) {
    return intersectionWith(ray);
  }

  /** Offers the closest hits of the rays within the tile's window. */
  void closestHits(final RayTile rays, final TileHits hits) {
    final TileWindow window = rays.window();
    int source = 0;
    for (int row = window.firstRow(); row <= window.lastRow(); row++) {
      for (int i = row * RayTile.SIZE + window.firstColumn(); i <= row * RayTile.SIZE + window.lastColumn(); i++) {
        final double distance = distance(rays.startX(i), rays.startY(i), rays.startZ(i),
            rays.directionX(i), rays.directionY(i), rays.directionZ(i));
        if (hits.isCloser(i, distance, 0)) {
          source = source != 0 ? source : hits.source(this, this);
          hits.take(i, distance, source, 0);
        } else if (Double.isNaN(distance)) {
          hits.askFor(i, this);
        }
      }
    }
  }

  /** Whether {@link #closestHits} is better than testing ray by ray. */
  boolean answersTiles() {
    return false;
  }

  /**
   * Whether a ray hits the object before a distance: the query of shadow rays.
   *
   * @param tmax the distance; a hit at this very distance does not count
   */
  boolean intersectsBefore(final Ray ray, final double tmax) {
    final double t = distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    return Double.isNaN(t) ? askFor(this, ray).distance() < tmax * FLOAT_LIMIT : t > 0 && t < tmax;
  }

  /** Adds this part of a group to its members: itself, or the objects of a group. */
  void addTo(final OpenedGroup members) {
    members.add(this);
  }

  /** Called when the object has become part of a group, directly or transformed. */
  void addContainer(final Group3D container) {
  }

  /** Called before a picture: groups within this object take note of boxes that have changed. */
  void refreshParts() {
  }

  /** Called when the object has become part of another. */
  void markContained() {
  }

  /** Finds the rays of a tile that the object blocks, among those that may cross the frustum's last projection. */
  void block(final ShadowTile tile) {
    tile.ask(this);
  }

  /** The texture; null, as by default, if there is none. */
  Texture texture() {
    return null;
  }

  /** Whether the colour of this object depends on where it is hit; a class may say so by overriding {@link #getColorAt}. */
  boolean isTextured() {
    return false;
  }

  /** Whether the parts of this object may have colours of their own. */
  boolean hasPartColors() {
    return false;
  }

  /** Colour of a part, as sRGB with alpha. */
  int argb(final int part) {
    return getColor().getRGB();
  }

  /** The cost of a query, see {@link Cost}. */
  int cost(final Ray ray) {
    return 1;
  }

  /**
   * The hit of a ray with an object, where a user-written object may return null. If it is the object that the ray
   * leaves, a hit at the start is ignored and the search continues behind it.
   */
  static Hit askFor(final Object3D object, final Ray ray) {
    final Hit hit = notNullHit(object, object.intersectionWith(ray));
    return ray.isBlindTo(hit)
        ? notNullHit(object, object.intersectionWith(ray.from(ray.blindness()))).seenFromBehind(ray.blindness()) : hit;
  }

  private static Hit notNullHit(final Object3D object, final Hit hit) {
    if (hit == null) {
      throw wrongState("nullHit", object.getClass().getName());
    }
    return hit;
  }

  /** {@link #intersectionWith} for an object that has {@link #distance} and {@link #hitAt}. */
  final Hit closestHit(final Ray ray) {
    notNull("ray", ray);
    final double t = distance(ray.startX(), ray.startY(), ray.startZ(),
        ray.directionX(), ray.directionY(), ray.directionZ());
    return Hit.isDistance(t) ? hitAt(ray, t, 0) : Hit.NOHIT;
  }
}
