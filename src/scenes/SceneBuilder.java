package scenes;

import java.awt.Color;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

import lights.Light;
import lights.LightGroup;
import models.Group3D;
import models.Object3D;
import view.Camera;
import view.Projection;

/** Reads the element {@code image} of a scene file, section by section, whatever their order in the file. */
final class SceneBuilder {

  /** Most pixels of a raster, as many as an array can hold. */
  private static final int LARGEST = Integer.MAX_VALUE - 8;

  /** Stops of exposure. */
  private static final Range STOPS = new Range(-20, true, 20, true);

  private final Element image;
  private final SceneGrammar grammar;
  private final Values values;
  private final Problems problems;
  private final Map<Object3D, String> names = new IdentityHashMap<>();
  private final MeshFiles files;
  private final TextureFiles textures;

  SceneBuilder(final Path file, final Element image, final SceneGrammar grammar, final Values values) {
    this.image = image;
    this.grammar = grammar;
    this.values = values;
    this.problems = values.problems();
    this.files = new MeshFiles(file, problems);
    this.textures = new TextureFiles(files, problems);
  }

  /** The scene; null if there is an error. */
  SceneFile scene() {
    final Element raster = section("raster");
    final int W = raster == null ? Values.NONE : values.integer(raster, "W", 1);
    final int H = raster == null ? Values.NONE : values.integer(raster, "H", 1);
    final Color background = raster == null ? null : new Colours(values).required(raster, "backgroundColor");
    final boolean tooLarge = W > 0 && H > 0 && (long) W * H > LARGEST;
    if (tooLarge) {
      problems.error(raster.find("W").valueOffset(), "rasterTooLarge", W, H, LARGEST);
    }
    rayTracer(section("rayTracer"));
    final Lighting lighting = lighting(section("engine"));
    final Camera camera = tooLarge ? camera(Values.NONE, Values.NONE) : camera(W, H);
    final Group3D objects = objects(lighting.on());
    final Element.Attribute name = image.attribute("name");
    return problems.hasErrors() ? null : new SceneFile(name == null ? "" : name.value(), W, H, background, lighting, camera,
        objects, Collections.unmodifiableMap(names), filesRead());
  }

  private Lighting lighting(final Element engine) {
    if (engine == null) {
      return Lighting.FACING;
    }
    final boolean illumination = values.bool(engine, "illumination");
    final boolean facing = values.bool(engine, "falseLighting", true);
    final int depth = values.integer(engine, "recursionDepth", 0, 0);
    final float exposure = values.number(engine, "exposure", STOPS, 0);
    final LightGroup lights = lights(illumination);
    if (!illumination) {
      return facing ? Lighting.FACING : Lighting.PLAIN;
    }
    return new Lighting(true, true, lights, Math.max(0, depth), Float.isNaN(exposure) ? 0 : exposure);
  }

  private Set<Path> filesRead() {
    final Set<Path> paths = new HashSet<>(files.paths());
    paths.addAll(textures.paths());
    return Set.copyOf(paths);
  }

  private Element section(final String name) {
    return values.required(image, name, Expected.SECTION);
  }

  /** Blocks only affect presentation: their sizes are checked, but the renderer chooses its own. */
  private void rayTracer(final Element rayTracer) {
    if (rayTracer != null) {
      block(rayTracer, "wblock");
      block(rayTracer, "hblock");
      values.bool(rayTracer, "showProgress");
    }
  }

  private void block(final Element rayTracer, final String name) {
    final int size = values.integer(rayTracer, name, Integer.MIN_VALUE);
    final Element value = rayTracer.find(name);
    if (value != null && size < 1 && size != Values.NONE) {
      problems.warning(value.valueOffset(), "blockSize", name, size);
    }
  }

  private Camera camera(final int W, final int H) {
    final ViewReader view = new ViewReader(values, grammar.types("projection"));
    final Element cameraElement = section("camera");
    final Camera camera = cameraElement == null ? null : view.camera(cameraElement);
    final Element projectionElement = section("projection");
    final Projection projection = projectionElement == null ? null : view.projection(projectionElement, W, H);
    if (camera != null && projection != null) {
      camera.setProjection(projection);
    }
    return camera;
  }

  private Group3D objects(final boolean illumination) {
    final MaterialReader materials = new MaterialReader(values, illumination);
    for (final String kind : new String[] {"brdf", "btdf"}) {
      for (final Element material : inBlocks("materials", kind)) {
        materials.read(material);
      }
    }
    final ModelReader models = new ModelReader(values, grammar.types("model"), files);
    for (final Element model : inBlocks("models", "model")) {
      models.read(model);
    }
    final Group3D group = new Group3D();
    final Element scene = section("scene");
    if (scene != null) {
      final ObjectReader objects = new ObjectReader(values, illumination, models, materials, textures);
      for (final Element object : scene.findAll("object")) {
        objects.read(object, group, names);
      }
    }
    return group;
  }

  /** The lights; without illumination one warning says that neither they nor materials have an effect. */
  private LightGroup lights(final boolean illumination) {
    final LightReader reader = new LightReader(values, grammar.types("light"));
    final LightGroup group = new LightGroup();
    final List<Element> lights = inBlocks("lights", "light");
    for (final Element element : lights) {
      final Light light = reader.read(element);
      if (light != null) {
        group.addLight(light);
      }
    }
    if (!illumination) {
      warnOfNoEffect();
    } else if (lights.isEmpty()) {
      problems.error(image.find("engine").find("illumination").valueOffset(), "noLight");
    }
    return group;
  }

  private void warnOfNoEffect() {
    final Element lights = image.find("lights");
    final Element materials = image.find("materials");
    final boolean materialsFirst = lights == null || materials != null && materials.offset() < lights.offset();
    final Element first = materialsFirst ? materials : lights;
    if (first != null) {
      problems.warning(first.offset(), "unlit");
    }
  }

  /** The elements of a name in all blocks of a name. */
  private List<Element> inBlocks(final String block, final String name) {
    final List<Element> found = new ArrayList<>();
    for (final Element element : image.findAll(name)) {
      Element ancestor = element.parent();
      while (ancestor != null && !ancestor.name().equals(block)) {
        ancestor = ancestor.parent();
      }
      if (ancestor != null) {
        found.add(element);
      }
    }
    return found;
  }
}
