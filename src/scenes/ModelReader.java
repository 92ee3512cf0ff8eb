package scenes;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

import arguments.Messages;

/** Reads the models of a scene file: their numbers, not their names. */
final class ModelReader {

  /** The types that this reader can build. */
  static final List<String> SUPPORTED = List.of("sphere", "box", "plane", "cylinder", "capsule", "truncone", "torus",
      "ellipsoid", "egg", "mesh");

  /** A model with its type; the shape is null if it is invalid or not supported. */
  record Entry(String type, Model model) {
  }

  private final Values values;
  private final List<String> types;
  private final MeshFiles meshes;
  private final Map<String, Entry> models = new HashMap<>();

  ModelReader(final Values values, final List<String> types, final MeshFiles meshes) {
    this.values = values;
    this.types = types;
    this.meshes = meshes;
  }

  /** Reads a model and stores it under its id, replacing an earlier one. */
  void read(final Element model) {
    final String id = values.attribute(model, "id");
    final String type = values.attribute(model, "type", types);
    final int before = values.problems().errors();
    final Model shape = type == null ? null : shape(model, type);
    final Entry entry = new Entry(type, values.problems().errors() == before ? shape : null);
    if (id != null && models.put(id, entry) != null) {
      values.problems().warning(model.attribute("id").offset(), "repeatedId", "model", Messages.quote(id));
    }
  }

  /** The ids of all models. */
  Set<String> ids() {
    return models.keySet();
  }

  /** The model of an id; null if none. */
  Entry get(final String id) {
    return models.get(id);
  }

  /** The shape of a type; valid only if no error was reported meanwhile. Null if the type is not supported. */
  private Model shape(final Element model, final String type) {
    return switch (type) {
      case "sphere" -> new Shapes.SphereModel(length(model, "radius"));
      case "box" -> new Shapes.BoxModel(length(model, "width"), length(model, "height"), length(model, "depth"));
      case "plane" -> new Shapes.PlaneModel(values.triple(model, "point", Range.ANY), normal(model));
      case "cylinder" -> new Shapes.CylinderModel(length(model, "radius"), length(model, "Axislength"));
      case "capsule" -> new Shapes.CapsuleModel(values.triple(model, "A", Range.ANY), values.triple(model, "B", Range.ANY),
          length(model, "radius"));
      case "truncone" -> truncatedCone(model);
      case "torus" -> new Shapes.TorusModel(length(model, "rotationalRadius"), length(model, Values.AS_SPELT));
      case "ellipsoid" -> new Shapes.EllipsoidModel(length(model, "a"), length(model, "b"), length(model, "c"));
      case "egg" -> egg(model);
      case "mesh" -> mesh(model);
      default -> null;
    };
  }

  private float length(final Element model, final String name) {
    return values.number(model, name, Range.POSITIVE);
  }

  private Model truncatedCone(final Element model) {
    final float[] a = values.triple(model, "A", Range.ANY), b = values.triple(model, "B", Range.ANY);
    final float radiusA = values.number(model, "radiusA", Range.NOT_NEGATIVE);
    final float radiusB = values.number(model, "radiusB", Range.NOT_NEGATIVE);
    if (a != null && Arrays.equals(a, b)) {
      final Element value = model.find("B");
      values.problems().error(value.valueOffset(), "samePoint", "B", "A", Messages.quote(value.text()));
    }
    if (radiusA == 0 && radiusB == 0) {
      values.problems().error(model.find("radiusB").valueOffset(), "bothZero", "radiusA", "radiusB");
    }
    return new Shapes.TruncatedConeModel(a, b, radiusA, radiusB);
  }

  private Model egg(final Element model) {
    final float a = length(model, "a"), b = length(model, "b"), w = length(model, "w");
    if (b <= w) {
      final Element value = model.find("b");
      values.problems().error(value.valueOffset(), "notGreater", "b", Messages.quote(value.text()), "w",
          Messages.quote(model.find("w").text()));
    }
    return new Shapes.EggModel(a, b, w);
  }

  private float[] normal(final Element model) {
    final float[] normal = values.triple(model, "normal", Range.ANY);
    if (normal != null && normal[0] == 0 && normal[1] == 0 && normal[2] == 0) {
      final Element value = model.find("normal");
      values.problems().error(value.valueOffset(), "nullVector", "normal", Messages.quote(value.text()));
    }
    return normal;
  }

  private Model mesh(final Element model) {
    final boolean flat = values.bool(model, "flat", false);
    final boolean promediated = values.bool(model, "promediatedNormals", false);
    final String path = values.name(model, "objFile");
    return path == null ? null : meshes.find(path, model.find("objFile").valueOffset(), flat, promediated);
  }
}
