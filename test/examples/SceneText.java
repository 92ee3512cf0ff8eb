package examples;

/** The text of a scene file, section by section, in the order of the course's own files. */
final class SceneText {

  private final StringBuilder text = new StringBuilder();
  private boolean lit;
  private boolean materials;
  private boolean objects;

  /**
   * Begins a scene.
   *
   * @param name its title
   * @param comment a comment for readers of the file, its lines separated by line feeds
   */
  SceneText(final String name, final String comment) {
    text.append("""
        <?xml version="1.0" encoding="UTF-8"?>
        <!--
        %s-->
        <image name="%s" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="scene.xsd">
        """.formatted(comment.indent(2), name));
  }

  /** Size in pixels, background, and whether colours are shaded by the angle between surface and ray. */
  SceneText raster(final int w, final int h, final String background, final boolean shaded) {
    return raster(w, h, background, "<illumination>false</illumination>\n    <falseLighting>" + shaded + "</falseLighting>");
  }

  /** Size in pixels and background of a scene with illumination, and how often rays may be reflected. */
  SceneText litRaster(final int w, final int h, final String background, final int recursionDepth) {
    lit = true;
    return raster(w, h, background, "<illumination>true</illumination>\n    <recursionDepth>" + recursionDepth
        + "</recursionDepth>");
  }

  private SceneText raster(final int w, final int h, final String background, final String engine) {
    text.append("""
          <raster>
            <W>%d</W>
            <H>%d</H>
            <backgroundColor>%s</backgroundColor>
          </raster>
          <rayTracer>
            <wblock>32</wblock>
            <hblock>32</hblock>
            <showProgress>true</showProgress>
          </rayTracer>
          <engine>
            %s
          </engine>
        """.formatted(w, h, background, engine));
    return this;
  }

  SceneText camera(final String position, final String lookAt, final String up) {
    text.append("""
          <camera>
            <position>%s</position>
            <lookAt>%s</lookAt>
            <up>%s</up>
          </camera>
        """.formatted(position, lookAt, up));
    return this;
  }

  /** The optics: names and values of what a type of projection needs. */
  SceneText projection(final String type, final String... values) {
    text.append("  <projection type=\"").append(type).append("\">\n");
    values("    ", values);
    text.append("  </projection>\n").append(lit ? "  <lights>\n" : "  <models>\n");
    return this;
  }

  /** A light: its type, names and values, its spectrum and position among them. */
  SceneText light(final String type, final String... values) {
    text.append("    <light type=\"").append(type).append("\">");
    inLine(values);
    text.append("</light>\n");
    return this;
  }

  /** A material that reflects; the first ends the lights. */
  SceneText brdf(final String id, final String type, final String... values) {
    text.append(materials ? "" : "  </lights>\n  <materials>\n");
    materials = true;
    text.append("    <brdf id=\"").append(id).append("\" type=\"").append(type).append("\">");
    inLine(values);
    text.append("</brdf>\n");
    return this;
  }

  /** A shape: names and values of what its type needs. */
  SceneText model(final String id, final String type, final String... values) {
    text.append(materials ? "  </materials>\n  <models>\n" : "");
    materials = false;
    text.append("    <model id=\"").append(id).append("\" type=\"").append(type).append("\">");
    inLine(values);
    text.append("</model>\n");
    return this;
  }

  /** An object: its model, its colour or with illumination its material, and names and values of its placement. */
  SceneText object(final String model, final String look, final String... placement) {
    endModels();
    text.append("    <object>");
    inLine("modelId", model, lit ? "materialId" : "color", look);
    inLine(placement);
    text.append("</object>\n");
    return this;
  }

  /** A line of comment between models or objects; before the first object it belongs to the objects. */
  SceneText comment(final String line) {
    endModels();
    text.append("    <!-- ").append(line).append(" -->\n");
    return this;
  }

  private void endModels() {
    if (!objects) {
      text.append("  </models>\n  <scene>\n");
      objects = true;
    }
  }

  private void values(final String indent, final String... values) {
    for (int i = 0; i < values.length; i += 2) {
      text.append(indent);
      inLine(values[i], values[i + 1]);
      text.append('\n');
    }
  }

  private void inLine(final String... values) {
    for (int i = 0; i < values.length; i += 2) {
      text.append('<').append(values[i]).append('>').append(values[i + 1]).append("</").append(values[i]).append('>');
    }
  }

  /** A colour between two others: the first at 0, the second at 1; components from 0 to 255. */
  static String blend(final double share, final int[] first, final int[] second) {
    final StringBuilder colour = new StringBuilder();
    for (int k = 0; k < 3; k++) {
      colour.append(k == 0 ? "" : " ").append(Math.round(first[k] + share * (second[k] - first[k])));
    }
    return colour.toString();
  }

  /** A colour by its place on a scale of colours that are evenly spaced from 0 to 1. */
  static String scale(final double place, final int[]... colours) {
    final double at = Math.max(0, Math.min(1, place)) * (colours.length - 1);
    final int first = Math.min((int) at, colours.length - 2);
    return blend(at - first, colours[first], colours[first + 1]);
  }

  @Override
  public String toString() {
    return text + "  </scene>\n</image>\n";
  }
}
