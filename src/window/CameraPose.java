package window;

import javax.vecmath.Point3d;
import javax.vecmath.Tuple3d;
import javax.vecmath.Vector3d;

import primitives.Point3D;
import primitives.Vector3D;
import view.Camera;
import view.FishEye;
import view.Orthographic;
import view.Perspective;
import view.Projection;

/**
 * A camera that can be moved: its position V, the point C that it looks at, its up vector and its projection. Immutable.
 *
 * @param V position
 * @param C the point looked at
 * @param up up vector, which is kept
 * @param projection the projection
 */
record CameraPose(Point3d V, Point3d C, Vector3d up, Projection projection) {

  /** Smallest angle between the line of sight and the up vector that turning leaves, in radians. */
  private static final double POLE = Math.toRadians(1);

  /** Significant digits of coordinates, relative to the distance between V and C. */
  private static final int DIGITS = 5;

  static CameraPose of(final Camera camera) {
    return new CameraPose(new Point3d(camera.getPosition()), new Point3d(camera.getLookAt()), new Vector3d(camera.getUp()),
        camera.getProjection());
  }

  /** The camera; coordinates are rounded to digits that a person would write. */
  Camera camera() {
    final double unit = Math.pow(10, Math.floor(Math.log10(V.distance(C))) + 1 - DIGITS);
    final Camera camera = new Camera(new Point3D(round(V.x, unit), round(V.y, unit), round(V.z, unit)),
        new Point3D(round(C.x, unit), round(C.y, unit), round(C.z, unit)),
        new Vector3D((float) up.x, (float) up.y, (float) up.z));
    camera.setProjection(projection);
    return camera;
  }

  /** A float stays the float that it was. */
  private static float round(final double coordinate, final double unit) {
    return (float) coordinate == coordinate ? (float) coordinate
        : (float) (unit < 1 ? Math.round(coordinate / unit) / (1 / unit) : Math.round(coordinate / unit) * unit);
  }

  private Vector3d fromTarget() {
    final Vector3d d = new Vector3d();
    d.sub(V, C);
    return d;
  }

  private static Vector3d unit(final Tuple3d tuple) {
    final Vector3d unit = new Vector3d(tuple);
    unit.normalize();
    return unit;
  }

  private Vector3d right() {
    final Vector3d right = new Vector3d();
    right.cross(up, fromTarget());
    return unit(right);
  }

  /** This camera turned about C: to the right about the up vector and upwards, in radians. */
  CameraPose turned(final double across, final double upwards) {
    final Vector3d d = fromTarget(), axis = unit(up), right = right(), level = new Vector3d();
    level.cross(right, axis);
    final double length = d.length();
    final double elevation = Math.asin(Math.max(-1, Math.min(1, d.dot(axis) / length)));
    final double limit = Math.PI / 2 - POLE, next = Math.max(-limit, Math.min(limit, elevation + upwards));
    final Vector3d turned = new Vector3d();
    turned.scale(Math.cos(across) * Math.cos(next), level);
    turned.scaleAdd(Math.sin(across) * Math.cos(next), right, turned);
    turned.scaleAdd(Math.sin(next), axis, turned);
    final Point3d position = new Point3d();
    position.scaleAdd(length, turned, C);
    return new CameraPose(position, C, up, projection);
  }

  /** This camera moved to the right and upwards, in parts of the height of the window at the distance of C. */
  CameraPose moved(final double across, final double upwards) {
    final double size = projection instanceof Orthographic ? projection.getHeight()
        : Math.min(2, projection.getHeight()) * V.distance(C);
    final Vector3d right = right(), upright = new Vector3d(), shift = new Vector3d();
    upright.cross(unit(fromTarget()), right);
    shift.scale(across * size, right);
    shift.scaleAdd(upwards * size, upright, shift);
    final Point3d position = new Point3d(V), target = new Point3d(C);
    position.add(shift);
    target.add(shift);
    return new CameraPose(position, target, up, projection);
  }

  /** This camera with its distance from C multiplied by a factor. */
  CameraPose atDistance(final double factor) {
    final Point3d position = new Point3d();
    position.scaleAdd(factor, fromTarget(), C);
    return new CameraPose(position, C, up, projection);
  }

  /** This camera with another kind of projection, which shows about the same part of the scene. */
  CameraPose withProjection(final Optics kind, final double aspect) {
    final double distance = V.distance(C);
    final double height = projection instanceof Orthographic ? projection.getHeight()
        : 2 * distance * Math.tan(Math.min(opening(), Math.toRadians(150)) / 2);
    final double angle = Math.toDegrees(2 * Math.atan(height / 2 / distance));
    return new CameraPose(V, C, up, switch (kind) {
      case PERSPECTIVE -> new Perspective((float) angle, (float) aspect);
      case ORTHOGRAPHIC -> new Orthographic((float) height, (float) (1 / aspect));
      case FISH_EYE -> new FishEye((float) angle);
    });
  }

  /** This camera with the opening of its projection widened by a factor, as far as it can be. */
  CameraPose widened(final double factor) {
    final double aspect = projection.getWidth() / (double) projection.getHeight();
    if (projection instanceof Orthographic) {
      return new CameraPose(V, C, up, new Orthographic((float) (projection.getHeight() * factor), (float) (1 / aspect)));
    }
    final float angle = (float) Math.max(1, Math.min(170, Math.toDegrees(opening()) * factor));
    if (projection instanceof Perspective) {
      return new CameraPose(V, C, up, new Perspective(angle, (float) aspect));
    }
    return projection instanceof FishEye ? new CameraPose(V, C, up, new FishEye(angle)) : this;
  }

  /** Vertical opening of a projection with one, in radians. */
  private double opening() {
    return projection instanceof FishEye ? 2 * Math.asin(Math.min(1, projection.getHeight() / 2))
        : 2 * Math.atan(projection.getHeight() / 2);
  }

  /** The kinds of projections of scene files. */
  enum Optics {
    /** Central projection. */
    PERSPECTIVE,
    /** Parallel projection. */
    ORTHOGRAPHIC,
    /** The fish-eye. */
    FISH_EYE
  }
}
