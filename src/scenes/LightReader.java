package scenes;

import java.util.Arrays;
import java.util.List;

import arguments.Messages;

/** Reads the lights of a scene file, as far as to tell what is wrong with them: they have no effect yet. */
final class LightReader {

  /** How far from 1 the sum of the shares of a spectrum may be. */
  private static final double TOLERANCE = 1e-4;

  private static final Range CONE = new Range(0, false, 90, true);

  private final Values values;
  private final List<String> types;

  LightReader(final Values values, final List<String> types) {
    this.values = values;
    this.types = types;
  }

  void read(final Element light) {
    final String type = values.attribute(light, "type", types);
    spectrum(light);
    values.number(light, "power", Range.POSITIVE);
    final float[] position = values.triple(light, "position", Range.ANY);
    if ("directional".equals(type) || "spot".equals(type)) {
      final float[] lookAt = values.triple(light, "lookAt", Range.ANY);
      if (position != null && lookAt != null && Arrays.equals(position, lookAt)) {
        final Element value = light.find("lookAt");
        values.problems().error(value.valueOffset(), "samePoint", "lookAt", "position", Messages.quote(value.text()));
      }
    }
    if ("directional".equals(type)) {
      values.number(light, "radius", Range.POSITIVE);
    } else if ("spot".equals(type)) {
      values.number(light, "aperture", CONE);
    }
  }

  private void spectrum(final Element light) {
    final float[] shares = values.triple(light, "spectrum", Range.NOT_NEGATIVE);
    if (shares != null && !(Math.abs((double) shares[0] + shares[1] + shares[2] - 1) <= TOLERANCE)) {
      final Element value = light.find("spectrum");
      values.problems().error(value.valueOffset(), "spectrum", Messages.quote(value.text()));
    }
  }
}
