package window;

import java.util.List;
import java.util.Locale;

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
import models.SphereTrace;
import tracer.Hit;
import tracer.Ray;

/** What is known of a pixel as a tree of lines of text. */
final class InspectionTree {

  /** Steps of a march that are listed, at most: the plot shows them all. */
  private static final int MOST_STEPS = 200;

  /** A line about a meeting, so that what is selected in the tree can be told. */
  record MeetingLine(Intersection meeting, String text) {
    @Override
    public String toString() {
      return text;
    }
  }

  private InspectionTree() {
  }

  static DefaultMutableTreeNode of(final Inspection inspection) {
    final PixelRay pixel = inspection.pixel();
    final DefaultMutableTreeNode root = node("inspect.pixel", pixel.m(), pixel.n(), pixel.W(), pixel.H());
    root.add(ray(pixel));
    root.add(meetings(inspection));
    root.add(colour(inspection));
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

  /** What comes out with the formula, and below it the numbers, a line for each term of a sum of vectors. */
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

  private static DefaultMutableTreeNode meetings(final Inspection inspection) {
    final List<Intersection> meetings = inspection.meetings();
    final long met = meetings.stream().filter(meeting -> meeting.hit().hits()).count();
    final DefaultMutableTreeNode node = node("inspect.meetings", met, inspection.tests());
    int number = 0;
    for (final Intersection meeting : meetings) {
      node.add(meeting(meeting, ++number));
    }
    return node;
  }

  private static DefaultMutableTreeNode meeting(final Intersection meeting, final int number) {
    final String name = meeting.name().isEmpty() ? "" : " \u201c" + meeting.name() + "\u201d";
    final String t = meeting.hit().hits() ? "t = " + Numbers.text(meeting.hit().getT())
        : Messages.text("window.inspect.noHit");
    final String mark = meeting.winner() ? "  \u2605 " + Messages.text("window.inspect.winner") : "";
    final DefaultMutableTreeNode node = new DefaultMutableTreeNode(new MeetingLine(meeting, number + ". "
        + meeting.object().getClass().getSimpleName() + name + ": " + t + mark));
    for (final ContractViolation finding : meeting.findings()) {
      add(node, "\u26a0 " + Messages.text("window.finding." + finding, meeting.failure()));
    }
    addHit(node, meeting.hit());
    add(node, meeting.object().toString());
    for (final LocalRay frame : meeting.frames()) {
      node.add(frame(frame));
    }
    meeting.march().ifPresent(march -> node.add(march(march)));
    return node;
  }

  private static void addRay(final DefaultMutableTreeNode node, final Ray ray) {
    add(node, "R = " + Numbers.text(ray.getStartingPoint()));
    add(node, "v = " + Numbers.text(ray.getDirection()));
  }

  private static void addHit(final DefaultMutableTreeNode node, final Hit hit) {
    if (hit.hits()) {
      node.add(node("inspect.point", Numbers.text(hit.getPoint())));
      node.add(node("inspect.normal", Numbers.text(hit.getNormal())));
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

  private static DefaultMutableTreeNode march(final SphereTrace march) {
    final DefaultMutableTreeNode node = node("inspect.march", march.steps().size(), Messages.text("window.march."
        + march.end()));
    int number = 0;
    for (final SphereTrace.Step step : march.steps().subList(0, Math.min(MOST_STEPS, march.steps().size()))) {
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

  /** A colour as red, green, blue, and alpha if it is not opaque. */
  static String colour(final int argb) {
    final String rgb = (argb >> 16 & 0xff) + " " + (argb >> 8 & 0xff) + " " + (argb & 0xff);
    return argb >>> 24 == 0xff ? rgb : rgb + " \u03b1 " + (argb >>> 24);
  }
}
