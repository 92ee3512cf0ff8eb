package scenes;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

import arguments.Messages;
import diagnostics.UnusualBlank;

/**
 * The names of the scene language, and the warnings about names that do not belong to it.
 *
 * <p>An element whose meaning depends on its {@code type} has a row for each. The elements of a row may be at any depth
 * below the section: an unknown element in between is reported, and its contents count all the same.
 */
final class SceneGrammar {

  /** A section, its type if that matters, and the elements that it may contain. */
  private static final String[] ROWS = {
    "image: raster rayTracer engine camera projection lights materials models scene",
    "raster: W H backgroundColor",
    "rayTracer: wblock hblock showProgress",
    "engine: illumination falseLighting recursionDepth exposure",
    "camera: position lookAt up",
    "projection perspective: fov aspect",
    "projection orthographic: height aspect",
    "projection angular: fov",
    "projection nlperspective: fov depthFactor",
    "lights: light",
    "light omnidirectional: spectrum power position",
    "light directional: spectrum power position lookAt radius",
    "light spot: spectrum power position lookAt aperture",
    "materials: brdf btdf",
    "brdf: diffuseReflectance conductiveReflectance ndf beta sigma alpha",
    "btdf: dielectricReflectance eta_int eta_ext ndf beta",
    "models: model",
    "model sphere: radius",
    "model box: width height depth",
    "model plane: point normal",
    "model cylinder: radius Axislength",
    "model capsule: A B radius",
    "model truncone: A B radiusA radiusB",
    "model torus: rotationalRadius circunferenceRadius",
    "model ellipsoid: a b c",
    "model egg: a b w",
    "model genus2:",
    "model mesh: objFile flat promediatedNormals",
    "scene: object",
    "object: modelId materialId textureFile color translation scaleFactors rotationAxis rotationAngle"
        + " iVector jVector kVector iauxVector jauxVector kauxVector",
  };

  /** The attributes that an element may have. */
  private static final Map<String, List<String>> ATTRIBUTES = Map.of("image", List.of("name"),
      "projection", List.of("type"), "light", List.of("type"), "brdf", List.of("id", "type"),
      "btdf", List.of("id", "type"), "model", List.of("id", "type"));

  /** Names of other editions of the language, without effect in this one. */
  private static final Set<String> DEAD = Set.of("light attenuationExponent", "model center");

  private final Problems problems;
  private final Map<String, Set<String>> children = new LinkedHashMap<>();

  /** The elements that an element may contain, whatever its type. */
  private final Map<String, Set<String>> ofAnyType = new HashMap<>();

  SceneGrammar(final Problems problems) {
    this.problems = problems;
    for (final String row : ROWS) {
      final int colon = row.indexOf(':');
      final Set<String> names = new LinkedHashSet<>(List.of(row.substring(colon + 1).strip().split(" ")));
      names.remove("");
      final String section = row.substring(0, colon);
      children.put(section, names);
      ofAnyType.computeIfAbsent(element(section), name -> new LinkedHashSet<>()).addAll(names);
    }
  }

  /** The element of a row, without its type. */
  private static String element(final String section) {
    final int blank = section.indexOf(' ');
    return blank < 0 ? section : section.substring(0, blank);
  }

  /** The names of all elements but {@code image}. */
  static Set<String> names() {
    final Set<String> names = new LinkedHashSet<>();
    for (final String row : ROWS) {
      names.addAll(List.of(row.substring(row.indexOf(':') + 1).strip().split(" ")));
    }
    names.remove("");
    return names;
  }

  /** The types that an element can have, in the order of the documentation. */
  List<String> types(final String element) {
    final List<String> types = new ArrayList<>();
    for (final String row : children.keySet()) {
      if (row.startsWith(element + ' ')) {
        types.add(row.substring(element.length() + 1));
      }
    }
    return types;
  }

  /** Reports what does not belong to the language in an element and below. */
  void check(final Element image) {
    if (image.name().equals("image")) {
      check(image, image);
      return;
    }
    problems.warning(image.offset(), "rootWrapped", image.name());
    for (final Element child : image.children()) {
      check(child);
    }
  }

  /** Checks an element in a section, which is the nearest element of the language around it, or itself. */
  private void check(final Element element, final Element section) {
    final boolean known = element == section;
    attributes(element, known);
    final Set<String> allowed = allowed(section);
    if (!element.text().trim().isEmpty() && (known || !element.children().isEmpty())) {
      strayText(element, section);
    }
    for (final Element child : element.children()) {
      if (allowed.contains(child.name())) {
        checkKnown(child);
      } else {
        unknown(child, section, allowed);
        check(child, isSection(child.name()) ? child : section);
      }
    }
  }

  private void strayText(final Element element, final Element section) {
    final String text = element.text();
    if (UnusualBlank.stripped(text).isEmpty()) {
      final int odd = UnusualBlank.indexIn(text);
      problems.warning(element.textOffset(odd), "oddBlank", section.name(), UnusualBlank.name(text.charAt(odd)));
    } else {
      problems.warning(element.valueOffset(), "strayText", Messages.quote(text), section.name());
    }
  }

  private void checkKnown(final Element element) {
    if (isSection(element.name())) {
      check(element, element);
      return;
    }
    attributes(element, true);
    for (final Element child : element.children()) {
      problems.warning(child.offset(), "insideValue", child.name(), element.name());
    }
  }

  private void unknown(final Element element, final Element section, final Set<String> allowed) {
    final String name = element.name();
    final String type = type(section);
    if (DEAD.contains(section.name() + ' ' + name)) {
      problems.warning(element.offset(), name);
    } else if (name.equals(Values.WELL_SPELT)) {
      problems.warning(element.offset(), "spelling", name, Values.AS_SPELT);
    } else if (type != null && all(section.name()).contains(name)) {
      problems.warning(element.offset(), "noEffect", name, section.name(), type);
    } else if (home(name) != null) {
      problems.warning(element.offset(), "misplaced", name, section.name(), home(name));
    } else {
      problems.warning(element.offset(), "unknownElement", Messages.quote(name), section.name(),
          problems.didYouMean(name, allowed));
    }
  }

  private void attributes(final Element element, final boolean known) {
    final List<String> allowed = known ? ATTRIBUTES.getOrDefault(element.name(), List.of()) : List.of();
    for (final Element.Attribute attribute : element.attributes()) {
      final String name = attribute.name();
      if (!allowed.contains(name) && !name.startsWith("xmlns") && name.indexOf(':') < 0) {
        problems.warning(attribute.offset(), "unknownAttribute", Messages.quote(name), element.name(),
            problems.didYouMean(name, allowed));
      }
    }
  }

  private boolean isSection(final String name) {
    return !all(name).isEmpty();
  }

  private static String type(final Element section) {
    final Element.Attribute attribute = section.attribute("type");
    return attribute == null ? null : UnusualBlank.stripped(attribute.value());
  }

  private Set<String> allowed(final Element section) {
    final Set<String> ofType = children.get(section.name() + ' ' + type(section));
    return ofType == null ? all(section.name()) : ofType;
  }

  private Set<String> all(final String name) {
    return ofAnyType.getOrDefault(name, Set.of());
  }

  /** The element in which a name belongs; null if the language does not have the name. */
  private String home(final String name) {
    for (final Map.Entry<String, Set<String>> row : children.entrySet()) {
      if (row.getValue().contains(name)) {
        return element(row.getKey());
      }
    }
    return null;
  }
}
