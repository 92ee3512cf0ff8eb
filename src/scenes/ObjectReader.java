package scenes;

import java.awt.Color;
import java.util.Map;
import java.util.Set;

import arguments.Messages;
import materials.Material;
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
    final Appearance look = illumination ? litAppearance(object) : unlitAppearance(object);
    final Placement placement = placements.read(object);
    if (model == null || look == null || placement == null) {
      return;
    }
    try {
      final Object3D placed = model.placed(placement, look);
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

  /** With illumination the material counts; an object that has none is matte, of its colour. */
  private Appearance litAppearance(final Element object) {
    if (values.has(object, "materialId")) {
      final Material material = material(object);
      return material == null ? null : Appearance.of(material);
    }
    if (values.has(object, "color")) {
      texture(object, true);
      values.problems().warning(object.find("color").offset(), "matte", "color");
      return plain(object);
    }
    final Element texture = object.find("textureFile");
    if (texture == null) {
      values.problems().error(object.offset(), "noMaterial");
    } else {
      values.problems().error(texture.offset(), "materialNeeded", texture.name());
    }
    return null;
  }

  /** Without illumination the colour counts, then the colour that stands for the material. */
  private Appearance unlitAppearance(final Element object) {
    final boolean coloured = values.has(object, "color");
    final Material material = values.has(object, "materialId") ? material(object) : null;
    final boolean textured = texture(object, coloured);
    if (coloured) {
      return plain(object);
    }
    if (material != null) {
      values.problems().warning(object.find("materialId").valueOffset(), "materialUnlit");
      return Appearance.of(material);
    }
    if (!textured && !values.has(object, "materialId")) {
      values.problems().error(object.offset(), "noColour");
    }
    return null;
  }

  private Appearance plain(final Element object) {
    final Color color = colours.of(values.optional(object, "color"));
    return color == null ? null : Appearance.of(color);
  }

  /** Reports that a texture has no effect; returns whether there is one. */
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

  /** The material that an object names; null if there is none of this id, or if it is invalid. */
  private Material material(final Element object) {
    final String id = values.name(object, "materialId");
    if (id != null && !materials.ids().contains(id)) {
      unknownId(object.find("materialId"), id, materials.ids());
    }
    return materials.get(id);
  }
}
