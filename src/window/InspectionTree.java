package window;

import java.awt.Color;
import java.util.List;
import java.util.Locale;
import java.util.Map;

import javax.swing.tree.DefaultMutableTreeNode;

import arguments.Messages;
import inspection.ColourStep;
import inspection.ContractViolation;
import inspection.Formula;
import inspection.Inspection;
import inspection.Intersection;
import inspection.LocalRay;
import inspection.Numbers;
import inspection.PixelRay;
import models.Object3D;
import models.SphereTrace;
import models.TextureLookup;
import models.Weights;
import tracer.Hit;
import tracer.Ray;

/** Presents the inspection of a pixel as a tree of lines of text. */
final class InspectionTree {

  /** Maximum number of listed steps of a sphere trace; the plot shows all of them. */
  private static final int MAX_STEPS = 200;

  /** A line about an intersection, from which the selection in the tree is resolved. */
  record IntersectionLine(Intersection intersection, String text) {
    @Override
    public String toString() {
      return text;
    }
  }

  private InspectionTree() {
  }

  /**
   * The lines of an inspection. Objects are asked for their text and their colour, so this may take long.
   *
   * @param names names of objects in the scene file
   * @param samples those of the picture
   */
  static DefaultMutableTreeNode of(final Inspection inspection, final Map<Object3D, String> names, final Samples samples) {
    final PixelRay pixel = inspection.pixel();
    final DefaultMutableTreeNode root = node("inspect.pixel", pixel.m(), pixel.n(), pixel.W(), pixel.H());
    root.add(ray(pixel));
    root.add(intersections(inspection));
    final DefaultMutableTreeNode colour = colour(inspection);
    if (samples.K() > 1) {
      colour.add(node("inspect.samples", samples));
    }
    inspection.light().ifPresent(light -> new LightLines(light, names).addTo(colour));
    if (inspection.light().isPresent()) {
      root.insert(colour, 0);
    } else {
      root.add(colour);
    }
    return root;
  }

  private static DefaultMutableTreeNode node(final String key, final Object... parts) {
    return new DefaultMutableTreeNode(Messages.text("window." + key, parts));
  }

  private static void add(final DefaultMutableTreeNode parent, final String text) {
    parent.add(new DefaultMutableTreeNode(text));
  }

  private static DefaultMutableTreeNode ray(final PixelRay pixel) {
    final DefaultMutableTreeNode node = node("inspect.ray", pixel.projection());
    for (final Formula formula : pixel.formulas()) {
      node.add(formula(formula));
    }
    if (pixel.ray() == Ray.NORAY) {
      node.add(node("inspect.noRay"));
    } else {
      final DefaultMutableTreeNode given = node("inspect.given", pixel.m(), pixel.n());
      addRay(given, pixel.ray());
      node.add(given);
    }
    return node;
  }

  /** The result with its formula; below it the numbers, one line for each term of a vector sum. */
  private static DefaultMutableTreeNode formula(final Formula formula) {
    final String general = formula.general().isEmpty() ? "" : "   =   " + formula.general();
    final DefaultMutableTreeNode node = new DefaultMutableTreeNode(formula.symbol() + " = " + formula.value() + general);
    for (final String term : formula.numbers().split("(?= [+\u2212] [^ ]+\u00b7\\()")) {
      if (!term.isEmpty()) {
        add(node, term.strip());
      }
    }
    return node;
  }

  private static DefaultMutableTreeNode intersections(final Inspection inspection) {
    final List<Intersection> intersections = inspection.intersections();
    final long hits = intersections.stream().filter(intersection -> intersection.hit().hits()).count();
    final DefaultMutableTreeNode node = node("inspect.intersections", hits, inspection.tests());
    int number = 0;
    for (final Intersection intersection : intersections) {
      node.add(intersection(intersection, ++number, inspection.pixel()));
    }
    return node;
  }

  private static DefaultMutableTreeNode intersection(final Intersection intersection, final int number,
      final PixelRay pixel) {
    final String name = intersection.name().isEmpty() ? "" : " \u201c" + intersection.name() + "\u201d";
    final String t = intersection.hit().hits() ? "t = " + Numbers.text(intersection.hit().getT())
        : Messages.text("window.inspect.noHit");
    final String mark = intersection.winner() ? "  \u2605 " + Messages.text("window.inspect.winner") : "";
    final DefaultMutableTreeNode node = new DefaultMutableTreeNode(new IntersectionLine(intersection, number + ". "
        + intersection.object().getClass().getSimpleName() + name + ": " + t + mark));
    for (final ContractViolation violation : intersection.violations()) {
      add(node, "\u26a0 " + Messages.text("window.violation." + violation, intersection.failure()));
    }
    addHit(node, intersection.hit());
    addTriangle(node, intersection, pixel);
    add(node, intersection.object().toString());
    for (final LocalRay frame : intersection.localRays()) {
      node.add(frame(frame));
    }
    intersection.trace().ifPresent(trace -> node.add(trace(trace)));
    return node;
  }

  /** The triangle of a mesh that was hit, and what its corners count there. */
  private static void addTriangle(final DefaultMutableTreeNode node, final Intersection intersection, final PixelRay pixel) {
    final List<LocalRay> frames = intersection.localRays();
    final LocalRay innermost = frames.isEmpty() ? null : frames.get(frames.size() - 1);
    final Hit hit = innermost == null ? intersection.hit() : innermost.hit();
    Weights.of(innermost == null ? pixel.ray() : innermost.ray(), hit).ifPresent(weights -> {
      if (hit.getObject() != intersection.object()) {
        add(node, hit.getObject().toString());
      }
      node.add(node("inspect.weights", LightLines.number(weights.a()), LightLines.number(weights.b()),
          LightLines.number(weights.c())));
    });
  }

  private static void addRay(final DefaultMutableTreeNode node, final Ray ray) {
    add(node, "R = " + Numbers.text(ray.getStartingPoint()));
    add(node, "v = " + Numbers.text(ray.getDirection()));
  }

  private static void addHit(final DefaultMutableTreeNode node, final Hit hit) {
    if (hit.hits()) {
      node.add(node("inspect.point", Numbers.text(hit.getPoint())));
      node.add(node("inspect.normal", Numbers.text(hit.getNormal())));
      addSurface(node, hit);
    }
  }

  /** What a smooth or textured surface adds: the normal of the facet, the texture coordinates and the colour there. */
  private static void addSurface(final DefaultMutableTreeNode node, final Hit hit) {
    if (!hit.getGeometricNormal().equals(hit.getNormal())) {
      node.add(node("inspect.geometricNormal", Numbers.text(hit.getGeometricNormal())));
    }
    if (!Double.isNaN(hit.textureU()) && !Double.isNaN(hit.textureV())) {
      final Color color = hit.getObject().getColorAt(hit);
      node.add(node("inspect.texture", Numbers.text((float) hit.textureU()), Numbers.text((float) hit.textureV()),
          colour(color.getRGB())));
      TextureLookup.of(hit).ifPresent(texel -> node.add(node("inspect.texel", texel.column(), texel.row(),
          texel.texture().getWidth(), texel.texture().getHeight(), colour(texel.argb()))));
    }
  }

  private static DefaultMutableTreeNode frame(final LocalRay frame) {
    final DefaultMutableTreeNode node = node("inspect.frame");
    addRay(node, frame.ray());
    if (frame.hit().hits()) {
      add(node, "t = " + Numbers.text(frame.hit().getT()));
    }
    addHit(node, frame.hit());
    return node;
  }

  private static DefaultMutableTreeNode trace(final SphereTrace trace) {
    final DefaultMutableTreeNode node = node("inspect.trace", trace.steps().size(), Messages.text("window.trace."
        + trace.end()));
    int number = 0;
    for (final SphereTrace.Step step : trace.steps().subList(0, Math.min(MAX_STEPS, trace.steps().size()))) {
      add(node, String.format(Locale.ROOT, "%d: t = %.6g, SDF = %.6g", ++number, step.t(), step.distance()));
    }
    return node;
  }

  private static DefaultMutableTreeNode colour(final Inspection inspection) {
    final DefaultMutableTreeNode node = node("inspect.colour", colour(inspection.argb()));
    for (final ColourStep step : inspection.colour()) {
      final String number = String.format(Locale.ROOT, "%.6f", step.number());
      add(node, Messages.text("window.colour." + step.kind(), number, colour(step.argb())));
    }
    return node;
  }

  /** A colour as red, green and blue, followed by alpha if it is not opaque. */
  static String colour(final int argb) {
    final String rgb = (argb >> 16 & 0xff) + " " + (argb >> 8 & 0xff) + " " + (argb & 0xff);
    return argb >>> 24 == 0xff ? rgb : rgb + " \u03b1 " + (argb >>> 24);
  }
}
