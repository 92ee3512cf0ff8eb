package inspection;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import models.Group3D;
import radiometry.RadianceRGB;
import rendering.LightObserver;
import tracer.Hit;
import tracer.Ray;

/** Builds the tree of a pixel's light from what is observed while its radiance is computed. */
final class LightTreeBuilder implements LightObserver {

  /** A surface whose rays may not have been followed yet. */
  private static final class Draft {

    private final Surface surface;
    private final List<LightNode.Lamp> lights = new ArrayList<>();
    private final List<Specular> rays = new ArrayList<>();

    Draft(final Surface surface) {
      this.surface = surface;
    }
  }

  private final Group3D scene;
  private final SceneObjects objects;
  private final Map<Ray, Draft> surfaces = new IdentityHashMap<>();
  private final Map<Ray, RadianceRGB> backgrounds = new IdentityHashMap<>();
  private Draft root;
  private Draft current;

  LightTreeBuilder(final Group3D scene) {
    this.scene = scene;
    this.objects = new SceneObjects(scene);
  }

  @Override
  public void surface(final Surface surface) {
    current = new Draft(surface);
    root = root == null ? current : root;
    surfaces.put(surface.ray(), current);
  }

  @Override
  public void light(final Contribution contribution) {
    final boolean blocked = contribution.outcome() == Outcome.BLOCKED;
    current.lights.add(new LightNode.Lamp(contribution, blocked ? blocker(contribution) : Optional.empty()));
  }

  private Optional<LightNode.Blocker> blocker(final Contribution contribution) {
    final Hit hit = scene.intersectionWith(contribution.shadowRay());
    return hit.hits() && hit.distance() < contribution.distance()
        ? Optional.of(new LightNode.Blocker(hit.getObject(), objects.of(contribution.shadowRay(), hit), hit.getPoint(),
            hit.getT())) : Optional.empty();
  }

  @Override
  public void specular(final Specular specular) {
    current.rays.add(specular);
  }

  @Override
  public void background(final Ray ray, final int depth, final RadianceRGB radiance) {
    backgrounds.put(ray, radiance);
  }

  /** The finished tree; empty if the ray of the pixel hits nothing. */
  Optional<LightNode> tree() {
    return Optional.ofNullable(root).map(this::node);
  }

  private LightNode node(final Draft draft) {
    final List<LightNode.Branch> branches = new ArrayList<>();
    for (final Specular specular : draft.rays) {
      final Optional<LightNode> target = Optional.ofNullable(surfaces.get(specular.ray())).map(this::node);
      branches.add(new LightNode.Branch(specular, product(draft.surface.weight(), specular.factor()), target,
          Optional.ofNullable(backgrounds.get(specular.ray()))));
    }
    return new LightNode(draft.surface, objects.of(draft.surface.ray(), draft.surface.hit()), draft.lights, branches);
  }

  private static RadianceRGB product(final RadianceRGB a, final RadianceRGB b) {
    return new RadianceRGB(a.getR() * b.getR(), a.getG() * b.getG(), a.getB() * b.getB());
  }
}
