package scenes;

import java.util.List;

import arguments.Messages;
import primitives.Point3D;
import primitives.Vector3D;
import view.Camera;
import view.FishEye;
import view.Orthographic;
import view.Perspective;
import view.Projection;

/** Reads camera and projection of a scene file. */
final class ViewReader {

  /** Full angles of perspective. */
  private static final Range OPENING = new Range(0, false, 180, false);
  /** Full angles of the fish-eye. */
  private static final Range FISH_EYE = new Range(0, false, 180, true);

  /** An aspect that differs more than this from that of the raster, relatively, causes a warning. */
  private static final double NOTICEABLE = 0.01;

  private final Values values;
  private final List<String> types;

  ViewReader(final Values values, final List<String> types) {
    this.values = values;
    this.types = types;
  }

  /** The camera, without projection; null if it is invalid. */
  Camera camera(final Element camera) {
    final float[] position = values.triple(camera, "position", Range.ANY);
    final float[] lookAt = values.triple(camera, "lookAt", Range.ANY);
    final float[] up = values.triple(camera, "up", Range.ANY);
    if (position == null || lookAt == null || up == null) {
      return null;
    }
    if (lookAt[0] == position[0] && lookAt[1] == position[1] && lookAt[2] == position[2]) {
      final Element value = camera.find("lookAt");
      values.problems().error(value.valueOffset(), "samePoint", "lookAt", "position", Messages.quote(value.text()));
      return null;
    }
    try {
      return new Camera(new Point3D(position[0], position[1], position[2]),
          new Point3D(lookAt[0], lookAt[1], lookAt[2]), new Vector3D(up[0], up[1], up[2]));
    } catch (final IllegalArgumentException noFrame) {
      final Element value = camera.find("up");
      final boolean zero = up[0] == 0 && up[1] == 0 && up[2] == 0;
      values.problems().error(value.valueOffset(), zero ? "nullVector" : "upAlongView", "up", Messages.quote(value.text()));
      return null;
    }
  }

  /** The projection for a raster, whose sizes are {@link Values#NONE} if invalid; null if the projection is invalid. */
  Projection projection(final Element projection, final int W, final int H) {
    final String type = values.attribute(projection, "type", types);
    try {
      return type == null ? null : projection(projection, type, W, H);
    } catch (final IllegalArgumentException notBuilt) {
      values.problems().error(projection.offset(), "notBuilt", notBuilt.getMessage());
      return null;
    }
  }

  private Projection projection(final Element projection, final String type, final int W, final int H) {
    switch (type) {
      case "perspective":
        final float opening = values.number(projection, "fov", OPENING);
        final float aspect = aspect(projection, W, H);
        return Float.isNaN(opening + aspect) ? null : new Perspective(opening, aspect);
      case "orthographic":
        final float height = values.number(projection, "height", Range.POSITIVE);
        final float inverse = 1 / aspect(projection, W, H);
        return Float.isNaN(height + inverse) ? null : new Orthographic(height, inverse);
      case "angular":
        final float fov = values.number(projection, "fov", FISH_EYE);
        return Float.isNaN(fov) ? null : fishEye(projection, fov, W, H);
      default:
        values.problems().error(projection.attribute("type").offset(), "projectionUnsupported", type);
        return null;
    }
  }

  /** The fish-eye of an angle; its window is square, so that a raster that is not causes a warning. */
  private Projection fishEye(final Element projection, final float fov, final int W, final int H) {
    if (W > 0 && H > 0 && Math.abs((double) H / W - 1) > NOTICEABLE) {
      values.problems().warning(projection.offset(), "aspectAngular", W + " x " + H);
    }
    return new FishEye(fov);
  }

  /** Width divided by height of the window, 1 unless given; a picture that will be squeezed causes a warning. */
  private float aspect(final Element projection, final int W, final int H) {
    final float aspect = values.number(projection, "aspect", Range.POSITIVE, 1);
    if (W > 0 && H > 0 && Math.abs((double) aspect * H / W - 1) > NOTICEABLE) {
      final boolean given = values.has(projection, "aspect");
      final int offset = given ? projection.find("aspect").valueOffset() : projection.offset();
      values.problems().warning(offset, given ? "aspectUnlike" : "aspectMissing", Float.toString(aspect),
          W + " x " + H, Float.toString(Math.round(1000.0 * W / H) / 1000f));
    }
    return aspect;
  }
}
