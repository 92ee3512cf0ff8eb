package scenes;

import java.awt.Color;
import java.util.Map;
import java.util.Set;

import arguments.Messages;
import materials.Material;
import materials.Texture;
import models.Appearance;
import models.Group3D;
import models.Object3D;

/** Reads the objects of a scene file: a model each, with its place and its appearance. */
final class ObjectReader {

  private final Values values;
  private final boolean illumination;
  private final ModelReader models;
  private final MaterialReader materials;
  private final TextureFiles textures;
  private final PlacementReader placements;
  private final Colours colours;

  ObjectReader(final Values values, final boolean illumination, final ModelReader models,
      final MaterialReader materials, final TextureFiles textures) {
    this.values = values;
    this.illumination = illumination;
    this.models = models;
    this.materials = materials;
    this.textures = textures;
    this.placements = new PlacementReader(values);
    this.colours = new Colours(values);
  }

  /** Adds the object of an element to a group, and the id of its model to the names, unless something is wrong with it. */
  void read(final Element object, final Group3D group, final Map<Object3D, String> names) {
    final String id = values.name(object, "modelId");
    final Model model = id == null ? null : model(object, id);
    final boolean own = values.has(object, "color") || values.has(object, "textureFile") || values.has(object, "materialId");
    final boolean brought = !own && model != null && model.hasMaterials();
    final Appearance appearance = brought ? null : illumination ? litAppearance(object) : unlitAppearance(object);
    final Placement placement = placements.read(object);
    if (model == null || appearance == null && !brought || placement == null) {
      return;
    }
    if (appearance != null && appearance.texture() != null && model.textureFault() != null) {
      values.problems().error(object.find("textureFile").valueOffset(), model.textureFault());
      return;
    }
    try {
      final Object3D placed = model.placed(placement, appearance);
      model.check(placement, object.offset());
      if (placed != null) {
        group.addObject(placed);
        names.put(placed, id);
      }
    } catch (final IllegalArgumentException notBuilt) {
      values.problems().error(object.offset(), "notBuilt", notBuilt.getMessage());
    }
  }

  /** The model that an object names; null if none, or if it is invalid. */
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

  /** With illumination the material counts; an object that has none is matte, of its texture or its colour. */
  private Appearance litAppearance(final Element object) {
    final Appearance plain = plain(object);
    if (values.has(object, "materialId")) {
      final Material material = material(object);
      return material == null ? null : Appearance.of(material);
    }
    final Element counts = object.find(values.has(object, "textureFile") ? "textureFile" : "color");
    if (counts == null) {
      values.problems().error(object.offset(), "noMaterial");
    } else {
      values.problems().warning(counts.offset(), counts.name().equals("color") ? "matte" : "matteTexture",
          counts.name());
    }
    return plain;
  }

  /** Without illumination the texture counts, else the colour, else the colour of the material. */
  private Appearance unlitAppearance(final Element object) {
    final Material material = values.has(object, "materialId") ? material(object) : null;
    if (values.has(object, "textureFile") || values.has(object, "color")) {
      return plain(object);
    }
    if (material != null) {
      values.problems().warning(object.find("materialId").valueOffset(), "materialUnlit");
      return Appearance.of(material);
    }
    if (!values.has(object, "materialId")) {
      values.problems().error(object.offset(), "noColour");
    }
    return null;
  }

  /** The texture of an object, or else its colour; null if it has neither, or if it is invalid. */
  private Appearance plain(final Element object) {
    final Element texture = values.optional(object, "textureFile"), color = values.optional(object, "color");
    final Color ofColor = color == null ? null : colours.of(color);
    if (texture == null) {
      return ofColor == null ? null : Appearance.of(ofColor);
    }
    final String path = values.name(texture);
    final Texture read = path == null ? null : textures.read(path, texture.valueOffset());
    return read == null ? null : Appearance.of(read);
  }

  /** The material that an object names; null if none of this id, or if it is invalid. */
  private Material material(final Element object) {
    final String id = values.name(object, "materialId");
    if (id != null && !materials.ids().contains(id)) {
      unknownId(object.find("materialId"), id, materials.ids());
    }
    return materials.get(id);
  }
}
