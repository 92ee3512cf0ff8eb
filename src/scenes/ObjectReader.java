package scenes;

import java.awt.Color;
import java.util.Map;
import java.util.Set;

import arguments.Messages;
import models.Group3D;
import models.Object3D;

/** Reads the objects of a scene file: a model each, with its place and its colour. */
final class ObjectReader {

  private final Values values;
  private final boolean illumination;
  private final ModelReader models;
  private final MaterialReader materials;
  private final MeshFiles files;
  private final PlacementReader placements;
  private final Colours colours;

  ObjectReader(final Values values, final boolean illumination, final ModelReader models,
      final MaterialReader materials, final MeshFiles files) {
    this.values = values;
    this.illumination = illumination;
    this.models = models;
    this.materials = materials;
    this.files = files;
    this.placements = new PlacementReader(values);
    this.colours = new Colours(values);
  }

  /** Adds the object of an element to a group, and the id of its model to the names, unless something is wrong with it. */
  void read(final Element object, final Group3D group, final Map<Object3D, String> names) {
    final String id = values.name(object, "modelId");
    final Model model = id == null ? null : model(object, id);
    final Color colour = illumination ? materialColour(object) : plainColour(object);
    final Placement placement = placements.read(object);
    if (model == null || colour == null || placement == null) {
      return;
    }
    try {
      final Object3D placed = model.placed(placement, colour);
      if (placed != null) {
        group.addObject(placed);
        names.put(placed, id);
      }
    } catch (final IllegalArgumentException notBuilt) {
      values.problems().error(object.offset(), "notBuilt", notBuilt.getMessage());
    }
  }

  /** The model of the id that an object names; null if there is none that can be shown. */
  private Model model(final Element object, final String id) {
    final ModelReader.Entry entry = models.get(id);
    if (entry == null) {
      unknownId(object.find("modelId"), id, models.ids());
    } else if (entry.type() != null && !ModelReader.SUPPORTED.contains(entry.type())) {
      values.problems().error(object.find("modelId").valueOffset(), "notSupported", Messages.quote(id), entry.type(),
          String.join(", ", ModelReader.SUPPORTED));
    }
    return entry == null ? null : entry.model();
  }

  private void unknownId(final Element value, final String id, final Set<String> ids) {
    values.problems().error(value.valueOffset(), "unknownId", value.name(), Messages.quote(id),
        values.problems().didYouMean(id, ids));
  }

  /** With illumination only a material counts; as it has no effect yet, a colour stands for it. */
  private Color materialColour(final Element object) {
    if (values.has(object, "materialId")) {
      return ofMaterial(object);
    }
    final Element other = values.has(object, "color") ? object.find("color") : object.find("textureFile");
    if (other == null) {
      values.problems().error(object.offset(), "noMaterial");
    } else {
      values.problems().error(other.offset(), "materialNeeded", other.name());
    }
    return null;
  }

  /** Without illumination the colour counts, then the colour that stands for the material. */
  private Color plainColour(final Element object) {
    final boolean coloured = values.has(object, "color");
    final Color material = values.has(object, "materialId") ? ofMaterial(object) : null;
    final boolean textured = texture(object, coloured);
    if (coloured) {
      return colours.of(values.optional(object, "color"));
    }
    if (material != null) {
      values.problems().warning(object.find("materialId").valueOffset(), "materialUnlit");
    } else if (!textured && !values.has(object, "materialId")) {
      values.problems().error(object.offset(), "noColour");
    }
    return material;
  }

  /** Tells what becomes of a texture; answers whether there is one. */
  private boolean texture(final Element object, final boolean coloured) {
    final Element value = values.optional(object, "textureFile");
    if (value == null) {
      return false;
    }
    final String path = values.name(value);
    if (path != null && files.existing(path, value.valueOffset(), "noTexture") != null) {
      if (coloured) {
        values.problems().warning(value.valueOffset(), "textureIgnored");
      } else {
        values.problems().error(value.valueOffset(), "textureUnsupported");
      }
    }
    return true;
  }

  private Color ofMaterial(final Element object) {
    final String id = values.name(object, "materialId");
    final Color colour = id == null ? null : materials.colour(id);
    if (id != null && colour == null) {
      unknownId(object.find("materialId"), id, materials.ids());
    }
    return colour;
  }
}
