package scenes;

import java.awt.Color;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

import arguments.Messages;

/**
 * Reads the materials of a scene file: tells what is wrong with them and keeps, of each, the colour that stands for it
 * as long as materials have no effect, the sum of its reflectances.
 */
final class MaterialReader {

  private static final List<String> BRDF = List.of("Phong-Lafortune", "Phong", "Ashikhmin-Shirley", "Cook-Torrance",
      "Oren-Nayar", "Ideal-Conductor");
  private static final List<String> BTDF = List.of("Ideal-Dielectric", "Cook-Torrance");
  private static final List<String> NDF = List.of("Blinn", "Horn", "Torrance", "GGX", "Beckmann");

  /** How far the sum of two reflectances, each rounded to a float, may exceed 1. */
  private static final double TOLERANCE = 1e-6;

  private final Values values;
  private final Map<String, Color> colours = new HashMap<>();

  MaterialReader(final Values values) {
    this.values = values;
  }

  /** The ids of all materials, also of those at fault. */
  Set<String> ids() {
    return colours.keySet();
  }

  /** The colour that stands for a material; null if there is none of this id. */
  Color colour(final String id) {
    return colours.get(id);
  }

  /** Reads an element {@code brdf} or {@code btdf}; of two with one id the later one counts. */
  void read(final Element material) {
    final boolean brdf = material.name().equals("brdf");
    final String id = values.attribute(material, "id");
    final String type = values.attribute(material, "type", brdf ? BRDF : BTDF);
    final Color colour = brdf ? reflecting(material, type) : refracting(material);
    values.oneOf(material, "ndf", NDF, "Blinn");
    values.number(material, "beta", Range.RIGHT_ANGLE, 0);
    if (id != null && colours.put(id, colour) != null) {
      values.problems().warning(material.attribute("id").offset(), "repeatedId", material.name(), Messages.quote(id));
    }
  }

  private Color reflecting(final Element material, final String type) {
    final float[] diffuse = reflectance(material, "diffuseReflectance", needsDiffuse(type));
    final float[] conductive = reflectance(material, "conductiveReflectance", needsConductive(type));
    values.number(material, "sigma", Range.RIGHT_ANGLE, 0);
    values.number(material, "alpha", Range.ANY, 0);
    if (!needsDiffuse(type) && !needsConductive(type) && isBlack(diffuse) && isBlack(conductive)) {
      values.problems().error(material.offset(), "noReflectance", material.name());
    }
    final float[] sum = {diffuse[0] + conductive[0], diffuse[1] + conductive[1], diffuse[2] + conductive[2]};
    final boolean energy = Math.max(sum[0], Math.max(sum[1], sum[2])) <= 1 + TOLERANCE;
    if (("Phong-Lafortune".equals(type) || "Phong".equals(type) || "Cook-Torrance".equals(type)) && !energy) {
      final Element value = material.find("conductiveReflectance");
      values.problems().error(value.valueOffset(), "reflectsMore", Messages.quote(value.text()));
    }
    return Colours.colour(sum, 255);
  }

  private static boolean needsDiffuse(final String type) {
    return "Ashikhmin-Shirley".equals(type) || "Oren-Nayar".equals(type);
  }

  private static boolean needsConductive(final String type) {
    return "Ashikhmin-Shirley".equals(type) || "Ideal-Conductor".equals(type);
  }

  private Color refracting(final Element material) {
    final float[] dielectric = reflectance(material, "dielectricReflectance", false);
    values.number(material, "eta_int", Range.POSITIVE);
    values.number(material, "eta_ext", Range.POSITIVE, 1);
    return Colours.colour(dielectric, 255);
  }

  /** A reflectance: black if it is not there or at fault; told if it must be there and is black. */
  private float[] reflectance(final Element material, final String name, final boolean needed) {
    final float[] triple = needed ? values.triple(material, name, Range.UNIT)
        : values.optionalTriple(material, name, Range.UNIT);
    if (needed && triple != null && isBlack(triple)) {
      values.problems().error(material.find(name).valueOffset(), "blackReflectance", name, material.name());
    }
    return triple == null ? new float[3] : triple;
  }

  private static boolean isBlack(final float[] triple) {
    return triple[0] == 0 && triple[1] == 0 && triple[2] == 0;
  }
}
