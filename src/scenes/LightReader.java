package scenes;

import java.util.Arrays;
import java.util.List;

import arguments.Messages;
import lights.Directional;
import lights.Light;
import lights.Omnidirectional;
import lights.Spot;
import primitives.Point3D;
import radiometry.SpectrumRGB;

/** Reads the lights of a scene file. */
final class LightReader {

  /** How far the sum of the shares of a spectrum may be from 1. */
  static final double TOLERANCE = 1e-4;

  /** Half angles of cones. */
  private static final Range CONE = new Range(0, false, 90, true);

  private final Values values;
  private final List<String> types;

  LightReader(final Values values, final List<String> types) {
    this.values = values;
    this.types = types;
  }

  /** The light of an element; null if something is wrong with it. */
  Light read(final Element light) {
    final int before = values.problems().errors();
    final String type = values.attribute(light, "type", types);
    final float[] shares = spectrum(light);
    final float power = values.number(light, "power", Range.POSITIVE);
    final float[] position = values.triple(light, "position", Range.ANY);
    final float[] lookAt = "directional".equals(type) || "spot".equals(type) ? lookAt(light, position) : null;
    final float size = "directional".equals(type) ? values.number(light, "radius", Range.POSITIVE)
        : "spot".equals(type) ? values.number(light, "aperture", CONE) : 0;
    if (values.problems().errors() > before) {
      return null;
    }
    final SpectrumRGB spectrum = new SpectrumRGB(shares[0], shares[1], shares[2]);
    return switch (type) {
      case "directional" -> new Directional(point(position), point(lookAt), size, spectrum, power);
      case "spot" -> new Spot(point(position), point(lookAt), size, spectrum, power);
      default -> new Omnidirectional(point(position), spectrum, power);
    };
  }

  private float[] lookAt(final Element light, final float[] position) {
    final float[] lookAt = values.triple(light, "lookAt", Range.ANY);
    if (position != null && lookAt != null && Arrays.equals(position, lookAt)) {
      final Element value = light.find("lookAt");
      values.problems().error(value.valueOffset(), "samePoint", "lookAt", "position", Messages.quote(value.text()));
    }
    return lookAt;
  }

  private float[] spectrum(final Element light) {
    final float[] shares = values.triple(light, "spectrum", Range.SHARE);
    if (shares != null && !(Math.abs((double) shares[0] + shares[1] + shares[2] - 1) <= TOLERANCE)) {
      final Element value = light.find("spectrum");
      values.problems().error(value.valueOffset(), "spectrum", Messages.quote(value.text()));
    }
    return shares;
  }

  private static Point3D point(final float[] triple) {
    return new Point3D(triple[0], triple[1], triple[2]);
  }
}
