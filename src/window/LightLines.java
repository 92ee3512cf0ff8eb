package window;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

import javax.swing.tree.DefaultMutableTreeNode;

import arguments.Messages;
import inspection.LightNode;
import inspection.LightRays;
import inspection.Numbers;
import inspection.PixelLight;
import inspection.Wireframe;
import models.Object3D;
import radiometry.RadianceRGB;
import rendering.LightObserver;

/** Presents the light of a pixel as a tree of lines of text whose numbers multiply out to the pixel's value. */
final class LightLines {

  /** Length of a ray that leaves the scene, in distances between its start and the previous one; long enough to be seen. */
  private static final float FREE_LENGTH = 1;

  /**
   * A line about a ray.
   *
   * @param rays the ray, and with a surface its parts
   * @param node the surface where it starts or ends
   * @param lamp the light that the line is about; empty for other lines
   */
  record RayLine(List<Wireframe.Line> rays, LightNode node, Optional<LightNode.Lamp> lamp, String text) {
    @Override
    public String toString() {
      return text;
    }
  }

  private final PixelLight light;
  private final Map<Object3D, String> names;

  LightLines(final PixelLight light, final Map<Object3D, String> names) {
    this.light = light;
    this.names = names;
  }

  /** Adds the light below the line about the colour. */
  void addTo(final DefaultMutableTreeNode parent) {
    final RadianceRGB v = light.radiance().times(light.gain());
    parent.add(line("light.pixel", number(light.exposure()), text(v)));
    parent.add(surface(light.root()));
  }

  private static DefaultMutableTreeNode line(final String key, final Object... parts) {
    return new DefaultMutableTreeNode(Messages.text("window." + key, parts));
  }

  private DefaultMutableTreeNode surface(final LightNode node) {
    final String text = Messages.text("window.light.surface", name(node.surface().hit().getObject(), node.sceneObject()),
        text(node.radiance()));
    final DefaultMutableTreeNode root = new DefaultMutableTreeNode(
        new RayLine(List.of(LightRays.of(node)), node, Optional.empty(), text));
    root.add(line("light.material", node.surface().material().getClass().getSimpleName(),
        Messages.text(node.surface().isOutside() ? "window.light.outside" : "window.light.inside")));
    for (final LightNode.Lamp lamp : node.lights()) {
      root.add(lamp(node, lamp));
    }
    for (final LightNode.Branch branch : node.branches()) {
      root.add(branch(node, branch));
    }
    return root;
  }

  private String name(final Object3D object, final Object3D sceneObject) {
    final String name = names.getOrDefault(sceneObject, "");
    return object.getClass().getSimpleName() + (name.isEmpty() ? "" : " \u201c" + name + "\u201d");
  }

  private DefaultMutableTreeNode lamp(final LightNode node, final LightNode.Lamp lamp) {
    final LightObserver.Contribution given = lamp.contribution();
    final boolean blocked = given.outcome() == LightObserver.Outcome.BLOCKED;
    final String first = blocked ? lamp.blocker().map(by -> name(by.object(), by.sceneObject())).orElse("?")
        : text(given.radiance());
    final String point = lamp.blocker().map(by -> Numbers.text(by.point())).orElse("?");
    final boolean isIdeal = given.outcome() == LightObserver.Outcome.NOT_REFLECTED && !node.surface().material().scatters();
    final String outcome = Messages.text("window.light." + (isIdeal ? "onlyIdeal" : given.outcome()), first, point);
    final String text = Messages.text("window.light.lamp", given.number() + 1, given.light().getClass().getSimpleName(),
        outcome);
    final DefaultMutableTreeNode line = new DefaultMutableTreeNode(
        new RayLine(LightRays.of(lamp), node, Optional.of(lamp), text));
    if (given.outcome() != LightObserver.Outcome.OUTSIDE_FIELD) {
      line.add(line("light.irradiance", text(given.irradiance())));
      line.add(line("light.cosine", number(given.cosine())));
    }
    if (given.outcome() == LightObserver.Outcome.LIT || given.outcome() == LightObserver.Outcome.BLOCKED) {
      line.add(line("light.brdf", text(quotient(given.reflected(), given.irradiance().times(given.cosine())))));
      line.add(line("light.product", text(node.surface().weight()), text(given.radiance())));
    }
    return line;
  }

  private DefaultMutableTreeNode branch(final LightNode node, final LightNode.Branch branch) {
    final LightObserver.Fate fate = branch.specular().fate();
    final String kind = Messages.text(branch.specular().isRefracted() ? "window.light.refraction"
        : "window.light.reflection");
    final String outcome = branch.background().isPresent() ? Messages.text("window.light.toBackground")
        : Messages.text("window.light." + fate, light.recursionDepth());
    final float length = FREE_LENGTH * node.ray().getStartingPoint().distance(node.surface().hit().getPoint());
    final List<Wireframe.Line> rays = fate == LightObserver.Fate.FOLLOWED ? List.of(LightRays.of(branch, length))
        : List.of();
    final String text = Messages.text("window.light.branch", kind, text(branch.radiance()), outcome);
    final DefaultMutableTreeNode line = new DefaultMutableTreeNode(new RayLine(rays, node, Optional.empty(), text));
    if (fate != LightObserver.Fate.TOTAL_REFLECTION) {
      line.add(line("light.factor", text(branch.specular().factor()), text(branch.weight())));
    }
    branch.target().ifPresent(target -> line.add(surface(target)));
    return line;
  }

  private static RadianceRGB quotient(final RadianceRGB a, final RadianceRGB b) {
    return new RadianceRGB(quotient(a.getR(), b.getR()), quotient(a.getG(), b.getG()), quotient(a.getB(), b.getB()));
  }

  private static double quotient(final double a, final double b) {
    return b == 0 ? 0 : a / b;
  }

  /** Three numbers; one if they are equal. */
  static String text(final RadianceRGB rgb) {
    final String r = number(rgb.getR()), g = number(rgb.getG()), b = number(rgb.getB());
    return r.equals(g) && g.equals(b) ? r : "(" + r + ", " + g + ", " + b + ")";
  }

  static String number(final double number) {
    final String text = number == 0 ? "0" : String.format(Locale.ROOT, "%.5g", number);
    return text.indexOf('e') >= 0 || text.indexOf('.') < 0 ? text : text.replaceAll("\\.?0+$", "");
  }
}
