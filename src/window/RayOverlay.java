package window;

import java.awt.Color;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import inspection.PixelProjector;
import inspection.Wireframe;
import primitives.Point3D;
import primitives.Vector3D;
import scenes.SceneFile;
import tracer.Ray;
import view.Orthographic;

/**
 * Rays projected into the picture, in coordinates of its pixels.
 *
 * @param parts the parts of the rays
 */
record RayOverlay(List<Part> parts) {

  /** A part of a ray in the picture, drawn strongly where no object hides it. */
  record Part(Path2D path, Color colour, boolean isVisible) {
  }

  static final RayOverlay NONE = new RayOverlay(List.of());

  /** Pieces of a ray whose visibility is determined: also a straight ray is curved by a fish-eye. */
  private static final int PIECES = 64;

  /** Part of the distance from the eye in which an object hides a point: the surface that it lies on does not. */
  private static final double BEFORE = 1 - 1e-4;

  /** Projects rays. Objects are tested for visibility, so this may take long. */
  static RayOverlay of(final List<Wireframe.Line> rays, final SceneFile scene, final int W, final int H) {
    final PixelProjector projector = new PixelProjector(scene.camera(), W, H);
    final List<Part> parts = new ArrayList<>();
    for (final Wireframe.Line ray : rays) {
      for (int i = 0; i < PIECES; i++) {
        final Optional<Point2D> a = projector.project(between(ray, (double) i / PIECES));
        final Optional<Point2D> b = projector.project(between(ray, (i + 1.0) / PIECES));
        if (a.isPresent() && b.isPresent()) {
          final Path2D path = new Path2D.Double();
          path.moveTo(a.get().getX(), a.get().getY());
          path.lineTo(b.get().getX(), b.get().getY());
          parts.add(new Part(path, WireframeColours.of(ray.kind()), isVisible(scene, between(ray, (i + 0.5) / PIECES))));
        }
      }
    }
    return new RayOverlay(List.copyOf(parts));
  }

  private static Point3D between(final Wireframe.Line ray, final double k) {
    final Point3D P = new Point3D(ray.from());
    P.interpolate(ray.to(), (float) k);
    return P;
  }

  private static boolean isVisible(final SceneFile scene, final Point3D P) {
    final Point3D eye = scene.camera().getPosition();
    if (scene.camera().getProjection() instanceof Orthographic) {
      final Vector3D look = scene.camera().getLook(), d = new Vector3D();
      d.sub(P, eye);
      eye.scaleAdd(-d.dot(look), look, P);
    }
    final double distance = eye.distance(P);
    return !(distance > 0) || !scene.objects().intersectAny(new Ray(eye, P), distance * BEFORE);
  }
}
