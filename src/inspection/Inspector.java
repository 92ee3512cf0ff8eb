package inspection;

import static arguments.Arguments.index;
import static arguments.Arguments.notNull;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import acceleration.RayTile;
import models.Cost;
import models.TileHits;
import scenes.SceneFile;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import upnatray.RenderJob;
import radiometry.RadianceRGB;
import rendering.Illumination;
import rendering.Shading;

/**
 * Inspects the pixels of a picture. It intersects the ray with every object of the scene, without an acceleration structure,
 * and so also finds hits of objects that a rendering would not have tested.
 */
public final class Inspector {

  private final SceneFile scene;
  private final Shading shading;
  private final RayGenerator generator;

  /**
   * An inspector of the picture of a scene.
   *
   * @param scene the scene, whose camera has a projection
   * @param W width of the picture in pixels, at least 1
   * @param H height of the picture in pixels, at least 1
   * @throws IllegalArgumentException if the scene is null, or W or H is not positive
   */
  public Inspector(final SceneFile scene, final int W, final int H) {
    this.scene = notNull("scene", scene);
    this.shading = RenderJob.shading(scene);
    this.generator = scene.camera().getRayGenerator(W, H);
  }

  /**
   * Inspects a pixel.
   *
   * @param m column, 0 … W − 1 from the left
   * @param n row, 0 … H − 1 from the bottom
   * @return the inspection
   * @throws IllegalArgumentException if there is no such pixel
   */
  public Inspection inspect(final int m, final int n) {
    final int W = generator.getWidth(), H = generator.getHeight();
    final Ray ray = generator.getRay(index("m", W, m), index("n", H, n));
    final String projection = scene.camera().getProjection().getClass().getSimpleName();
    final List<Formula> formulas = new RayFormulas(scene.camera(), W, H, m, n).of(ray);
    final Hit hit = closest(m, n);
    return new Inspection(new PixelRay(m, n, W, H, projection, formulas, ray), intersections(ray, hit), colour(ray, hit),
        tests(ray), light(ray, hit));
  }

  /**
   * The closest hit that a rendering finds, by the tile of rays that the pixel belongs to. Mistakes in an object, such as a
   * bounding box that is too small, take effect here as they do in the picture.
   */
  private Hit closest(final int m, final int n) {
    final int column = m % RayTile.SIZE, row = n % RayTile.SIZE, firstM = m - column, firstN = n - row;
    final RayTile rays = new RayTile();
    final TileHits hits = new TileHits(rays);
    rays.open(Math.min(RayTile.SIZE, generator.getWidth() - firstM), Math.min(RayTile.SIZE, generator.getHeight() - firstN));
    generator.fill(rays, firstM, firstN);
    rays.close();
    hits.clear();
    try {
      scene.objects().closestHits(rays, hits);
      return hits.hit(row * RayTile.SIZE + column);
    } catch (final RuntimeException | StackOverflowError failed) {
      return Hit.NOHIT;
    }
  }

  private List<Intersection> intersections(final Ray ray, final Hit closest) {
    final List<Intersection> intersections = ray == Ray.NORAY ? new ArrayList<>()
        : new ArrayList<>(new AllIntersections(scene, ray).all());
    intersections.sort(Comparator.comparing(intersection -> intersection.hit().getT()));
    for (int i = 0; i < intersections.size(); i++) {
      if (closest.hits() && intersections.get(i).hit().getObject() == closest.getObject()) {
        intersections.set(i, intersections.get(i).asWinner());
        break;
      }
    }
    return intersections;
  }

  /** The cost of the ray; 0 if an object throws. */
  private int tests(final Ray ray) {
    try {
      return Cost.of(scene.objects(), ray);
    } catch (final RuntimeException | StackOverflowError failed) {
      return 0;
    }
  }

  private Optional<PixelLight> light(final Ray ray, final Hit hit) {
    if (!hit.hits() || !(shading instanceof Illumination illumination)) {
      return Optional.empty();
    }
    final LightTreeBuilder builder = new LightTreeBuilder(scene.objects());
    final RadianceRGB radiance = illumination.radiance(ray, hit, builder);
    return builder.tree().map(root -> new PixelLight(root, radiance, illumination.exposure(),
        illumination.recursionDepth()));
  }

  private List<ColourStep> colour(final Ray ray, final Hit hit) {
    if (!hit.hits()) {
      final ColourStep.Kind kind = ray == Ray.NORAY ? ColourStep.Kind.NO_RAY : ColourStep.Kind.BACKGROUND;
      return List.of(new ColourStep(kind, 0, scene.background().getRGB()));
    }
    if (shading instanceof Illumination) {
      return List.of(new ColourStep(ColourStep.Kind.RADIANCE, 0, shading.argb(ray, hit)));
    }
    final ColourStep object = new ColourStep(ColourStep.Kind.OBJECT, 0, Shading.PLAIN.argb(ray, hit));
    if (shading != Shading.FACING) {
      return List.of(object);
    }
    final double cosine = Math.abs(hit.normalX() * ray.directionX() + hit.normalY() * ray.directionY()
        + hit.normalZ() * ray.directionZ());
    return List.of(object, new ColourStep(ColourStep.Kind.COSINE, cosine, shading.argb(ray, hit)));
  }
}
