package scenes;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

import arguments.Messages;
import materials.AshikhminShirley;
import materials.Beckmann;
import materials.Blinn;
import materials.GGX;
import materials.Horn;
import materials.IdealConductor;
import materials.IdealDielectric;
import materials.Material;
import materials.NormalDistributionFunction;
import materials.OrenNayar;
import materials.PhongLafortune;
import materials.ReflectiveCookTorrance;
import materials.Torrance;
import materials.TransmissiveCookTorrance;
import radiometry.ReflectanceRGB;

/**
 * Reads the materials of a scene file. Children that a type does not use are accepted, but an invalid value in them is an
 * error all the same. With illumination, a surface that will probably look unintended causes a warning.
 */
final class MaterialReader {

  private static final List<String> BRDF = List.of("Phong-Lafortune", "Phong", "Ashikhmin-Shirley", "Cook-Torrance",
      "Oren-Nayar", "Ideal-Conductor");
  private static final List<String> BTDF = List.of("Ideal-Dielectric", "Cook-Torrance");
  private static final List<String> NDF = List.of("Blinn", "Horn", "Torrance", "GGX", "Beckmann");

  /** Index of refraction of air. */
  private static final float AIR = 1.0002926f;

  /** How far the sum of two reflectances, each rounded to a float, may exceed 1. */
  private static final double TOLERANCE = 1e-6;

  private final Values values;
  private final boolean illumination;
  private final Map<String, Material> materials = new HashMap<>();

  MaterialReader(final Values values, final boolean illumination) {
    this.values = values;
    this.illumination = illumination;
  }

  /** The ids of all materials, invalid ones included. */
  Set<String> ids() {
    return materials.keySet();
  }

  /** The material of an id; null if none, or if it is invalid. */
  Material get(final String id) {
    return materials.get(id);
  }

  /** Reads an element {@code brdf} or {@code btdf}; of two with the same id the later one counts. */
  void read(final Element element) {
    final boolean brdf = element.name().equals("brdf");
    final String id = values.attribute(element, "id");
    final int before = values.problems().errors();
    final String type = values.attribute(element, "type", brdf ? BRDF : BTDF);
    final String ndf = values.oneOf(element, "ndf", NDF, "Blinn");
    final float beta = values.number(element, "beta", Range.RIGHT_ANGLE, 0);
    final Material material = brdf ? reflecting(element, type, ndf, beta, before)
        : refracting(element, type, ndf, beta, before);
    if (id != null) {
      if (materials.containsKey(id)) {
        values.problems().warning(element.attribute("id").offset(), "repeatedId", element.name(), Messages.quote(id));
      }
      materials.put(id, material);
    }
  }

  private Material reflecting(final Element element, final String type, final String ndf, final float beta,
      final int errorsBefore) {
    final int errors = values.problems().errors();
    final float[] diffuse = reflectance(element, "diffuseReflectance", needsDiffuse(type));
    final float[] conductive = reflectance(element, "conductiveReflectance", needsConductive(type));
    final boolean isSound = values.problems().errors() == errors;
    final float sigma = values.number(element, "sigma", Range.RIGHT_ANGLE, 0);
    values.number(element, "alpha", Range.ANY, 0);
    final boolean lobe = !"Oren-Nayar".equals(type) && !"Ideal-Conductor".equals(type);
    if (isSound && type != null && !needsDiffuse(type) && !needsConductive(type)) {
      checkEnergy(element, diffuse, conductive);
    }
    if (lobe && !isBlack(conductive)) {
      warnIfPolished(element);
    }
    if (values.problems().errors() > errorsBefore) {
      return null;
    }
    final NormalDistributionFunction distribution = lobe ? distribution(ndf, beta) : null;
    return switch (type) {
      case "Ashikhmin-Shirley" -> new AshikhminShirley(factors(diffuse), factors(conductive), distribution);
      case "Cook-Torrance" -> new ReflectiveCookTorrance(factors(diffuse), factors(conductive), distribution);
      case "Oren-Nayar" -> new OrenNayar(factors(diffuse), sigma);
      case "Ideal-Conductor" -> new IdealConductor(factors(conductive));
      default -> new PhongLafortune(factors(diffuse), factors(conductive), distribution);
    };
  }

  /** Checks that a material reflects something, and no more than it receives. */
  private void checkEnergy(final Element element, final float[] diffuse, final float[] conductive) {
    if (isBlack(diffuse) && isBlack(conductive)) {
      values.problems().error(element.offset(), "noReflectance", element.name());
    }
    for (int channel = 0; channel < 3; channel++) {
      if ((double) diffuse[channel] + conductive[channel] > 1 + TOLERANCE) {
        final Element value = element.find("conductiveReflectance");
        values.problems().error(value.valueOffset(), "reflectsMore", Messages.quote(value.text()));
        return;
      }
    }
  }

  private Material refracting(final Element element, final String type, final String ndf, final float beta,
      final int errorsBefore) {
    final int errors = values.problems().errors();
    final float[] dielectric = reflectance(element, "dielectricReflectance", false);
    final boolean isSound = values.problems().errors() == errors;
    final float inside = values.number(element, "eta_int", Range.POSITIVE);
    final float outside = values.number(element, "eta_ext", Range.POSITIVE, AIR);
    final boolean rough = "Cook-Torrance".equals(type);
    if (rough) {
      warnIfPolished(element);
    }
    if (illumination && isBlack(dielectric) && isSound) {
      values.problems().warning(element.offset(), "blackDielectric", element.name());
    }
    if (values.problems().errors() > errorsBefore) {
      return null;
    }
    return rough ? new TransmissiveCookTorrance(factors(dielectric), inside, outside, distribution(ndf, beta))
        : new IdealDielectric(factors(dielectric), inside, outside);
  }

  private void warnIfPolished(final Element element) {
    if (illumination && !values.has(element, "beta")) {
      final String key = element.name().equals("brdf") ? "polished" : "polishedGlass";
      values.problems().warning(element.offset(), key, element.name());
    }
  }

  private static NormalDistributionFunction distribution(final String ndf, final float beta) {
    return switch (ndf) {
      case "Horn" -> new Horn(beta);
      case "Torrance" -> new Torrance(beta);
      case "GGX" -> new GGX(beta);
      case "Beckmann" -> new Beckmann(beta);
      default -> new Blinn(beta);
    };
  }

  private static boolean needsDiffuse(final String type) {
    return "Ashikhmin-Shirley".equals(type) || "Oren-Nayar".equals(type);
  }

  private static boolean needsConductive(final String type) {
    return "Ashikhmin-Shirley".equals(type) || "Ideal-Conductor".equals(type);
  }

  /** A reflectance: black if it is missing or invalid. It is an error if a required one is black. */
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

  private static ReflectanceRGB factors(final float[] triple) {
    return new ReflectanceRGB(triple[0], triple[1], triple[2]);
  }
}
