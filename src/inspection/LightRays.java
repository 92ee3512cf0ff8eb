package inspection;

import static arguments.Arguments.notNull;

import java.util.ArrayList;
import java.util.List;

import primitives.Point3D;
import rendering.LightObserver;
import tracer.Hit;
import tracer.Ray;

/** The rays of a pixel's light as lines in space: shadow rays, lit or blocked, and ideally reflected and refracted rays. */
public final class LightRays {

  private LightRays() {
  }

  /**
   * All rays that leave a surface and the surfaces seen in it.
   *
   * @param node the surface
   * @param length length of a ray that leaves the scene
   * @return the lines, in the order of the tree
   * @throws IllegalArgumentException if the node is null
   */
  public static List<Wireframe.Line> of(final LightNode node, final float length) {
    final List<Wireframe.Line> lines = new ArrayList<>();
    collect(notNull("node", node), length, lines);
    return lines;
  }

  private static void collect(final LightNode node, final float length, final List<Wireframe.Line> lines) {
    for (final LightNode.Lamp lamp : node.lights()) {
      if (lamp.contribution().shadowRay() != Ray.NORAY) {
        lines.addAll(of(lamp));
      }
    }
    for (final LightNode.Branch branch : node.branches()) {
      if (branch.specular().fate() == LightObserver.Fate.FOLLOWED) {
        lines.add(of(branch, length));
        branch.target().ifPresent(target -> collect(target, length, lines));
      }
    }
  }

  /**
   * The shadow ray of a light: up to the light, or up to what blocks it and from there on.
   *
   * @param lamp a light at a surface
   * @return the lines; none if no shadow ray was traced
   * @throws IllegalArgumentException if the lamp is null
   */
  public static List<Wireframe.Line> of(final LightNode.Lamp lamp) {
    final Ray ray = notNull("lamp", lamp).contribution().shadowRay();
    if (ray == Ray.NORAY) {
      return List.of();
    }
    final Point3D light = ray.pointAtParameter((float) lamp.contribution().distance());
    final boolean lit = lamp.contribution().outcome() == LightObserver.Outcome.LIT;
    return List.of(line(lit ? Wireframe.Kind.SHADOW_LIT : Wireframe.Kind.SHADOW_BLOCKED, ray.getStartingPoint(),
        lamp.blocker().map(LightNode.Blocker::point).orElse(light)));
  }

  /**
   * A reflected or refracted ray, up to its hit.
   *
   * @param branch a ray that is followed
   * @param length its length if it leaves the scene
   * @return the line
   * @throws IllegalArgumentException if the branch is null
   */
  public static Wireframe.Line of(final LightNode.Branch branch, final float length) {
    final Ray ray = notNull("branch", branch).specular().ray();
    final Point3D end = branch.target().map(target -> target.surface().hit().getPoint())
        .orElseGet(() -> ray.pointAtParameter(length));
    return line(branch.specular().isRefracted() ? Wireframe.Kind.REFRACTED : Wireframe.Kind.REFLECTED,
        ray.getStartingPoint(), end);
  }

  /**
   * The ray that hits a surface.
   *
   * @param node the surface
   * @return the line
   * @throws IllegalArgumentException if the node is null
   */
  public static Wireframe.Line of(final LightNode node) {
    final Hit hit = notNull("node", node).surface().hit();
    return line(Wireframe.Kind.RAY, node.ray().getStartingPoint(), hit.getPoint());
  }

  private static Wireframe.Line line(final Wireframe.Kind kind, final Point3D from, final Point3D to) {
    return new Wireframe.Line(kind, from, to, 0);
  }
}
