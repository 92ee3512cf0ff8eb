package inspection;

import static arguments.Arguments.notNull;
import static arguments.Arguments.positive;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import models.Group3D;
import models.Object3D;
import models.Plane;
import primitives.BoundingBox;
import primitives.Point3D;
import primitives.Vector3D;
import scenes.SceneFile;
import tracer.Hit;
import tracer.Ray;
import view.Camera;
import view.Orthographic;
import view.Projection;

/**
 * A scene and its camera as a line drawing in space: the camera's frame, the window of the projection with its grid of
 * pixels, the boxes of the objects, and the ray of a pixel. It is for looking at from outside.
 */
public final class Wireframe {

  /** More boxes than this would be a tangle. */
  private static final int MOST_BOXES = 2000;

  /** Lines of the pixel grid to each side, at most; where there are more pixels, each square stands for several. */
  private static final int MOST_GRID_LINES = 16;

  /** What a line is part of. */
  public enum Kind {
    /** The camera's x. */
    AXIS_X,
    /** The camera's y. */
    AXIS_Y,
    /** The camera's z, against the view. */
    AXIS_Z,
    /** The rim of the window of the projection. */
    WINDOW,
    /** The pixels in the window. */
    GRID,
    /** From the camera through the corners of the window, or through the rim of a fish-eye. */
    FRUSTUM,
    /** The box of an object. */
    BOX,
    /** The box of an object around the camera, such as a sky. */
    AROUND,
    /** A square of a plane, which has no end. */
    PLANE,
    /** The ray of the pinned pixel, up to what it meets. */
    RAY,
    /** The normal where it meets it. */
    NORMAL
  }

  /**
   * A line between two points of the scene.
   *
   * @param kind what it is part of
   * @param from one end
   * @param to the other end
   * @param argb colour of the object that a box is about, or of a plane; 0 if it has none, and for all other kinds
   */
  public record Line(Kind kind, Point3D from, Point3D to, int argb) {
  }

  private final SceneFile scene;
  private final Camera camera;
  private final int W;
  private final int H;
  private final List<Line> lines = new ArrayList<>();
  private BoundingBox bounds;

  private Wireframe(final SceneFile scene, final int W, final int H) {
    this.scene = notNull("scene", scene);
    this.camera = scene.camera();
    this.W = positive("W", W);
    this.H = positive("H", H);
    this.bounds = new BoundingBox(camera.getPosition(), camera.getPosition());
  }

  /**
   * The drawing of a scene.
   *
   * @param scene the scene, whose camera has a projection
   * @param W width of the picture in pixels, at least 1
   * @param H height of the picture in pixels, at least 1
   * @return the lines, without a ray
   * @throws IllegalArgumentException if the scene is null or there is no pixel
   */
  public static List<Line> of(final SceneFile scene, final int W, final int H) {
    return of(scene, W, H, Ray.NORAY, Hit.NOHIT);
  }

  /**
   * The drawing of a scene with a ray.
   *
   * @param scene the scene, whose camera has a projection
   * @param W width of the picture in pixels, at least 1
   * @param H height of the picture in pixels, at least 1
   * @param ray the ray; {@link Ray#NORAY} for none
   * @param hit what it meets; {@link Hit#NOHIT} for nothing
   * @return the lines
   * @throws IllegalArgumentException if an argument is null or there is no pixel
   */
  public static List<Line> of(final SceneFile scene, final int W, final int H, final Ray ray, final Hit hit) {
    final Wireframe outline = new Wireframe(scene, W, H);
    outline.addBoxes(scene.objects());
    outline.bounds = bounds(outline.lines).union(outline.bounds);
    outline.addPlanes(scene.objects());
    outline.addCamera();
    if (notNull("ray", ray) != Ray.NORAY) {
      outline.addRay(ray, notNull("hit", hit));
    }
    return List.copyOf(outline.lines);
  }

  /**
   * The box of what is to be seen of a drawing: without the lines from the camera through the corners of the window, and
   * without what is around the camera, unless there are no other objects.
   *
   * @param lines a drawing
   * @return the box
   * @throws IllegalArgumentException if the lines are null
   */
  public static BoundingBox bounds(final List<Line> lines) {
    final boolean inside = notNull("lines", lines).stream().noneMatch(line -> line.kind() == Kind.BOX);
    BoundingBox box = BoundingBox.EMPTY;
    for (final Line line : lines) {
      if (line.kind() != Kind.FRUSTUM && (inside || line.kind() != Kind.AROUND)) {
        box = box.union(new BoundingBox(line.from(), line.from())).union(new BoundingBox(line.to(), line.to()));
      }
    }
    return box;
  }

  private void addBoxes(final Group3D group) {
    for (final Object3D object : group.getObjects()) {
      final BoundingBox box = boxOf(object);
      if (object instanceof Group3D part) {
        addBoxes(part);
      } else if (box != null && box.isFinite() && lines.size() < MOST_BOXES * 12) {
        addBox(box, object.getColor() == null ? 0 : object.getColor().getRGB());
      }
    }
  }

  /** The box of an object; null for one that cannot tell. The inspector tells of it, the drawing does without. */
  private static BoundingBox boxOf(final Object3D object) {
    try {
      return object.getBoundingBox();
    } catch (final RuntimeException | StackOverflowError failed) {
      return null;
    }
  }

  /** Each edge joins two corners that differ in one coordinate, which are numbered by their bits. */
  private void addBox(final BoundingBox box, final int argb) {
    final Kind kind = box.contains(camera.getPosition()) ? Kind.AROUND : Kind.BOX;
    for (int corner = 0; corner < 8; corner++) {
      for (int bit = 1; bit < 8; bit <<= 1) {
        if ((corner & bit) == 0) {
          lines.add(new Line(kind, corner(box, corner), corner(box, corner | bit), argb));
        }
      }
    }
  }

  private static Point3D corner(final BoundingBox box, final int bits) {
    return new Point3D((bits & 1) == 0 ? box.minX() : box.maxX(), (bits & 2) == 0 ? box.minY() : box.maxY(),
        (bits & 4) == 0 ? box.minZ() : box.maxZ());
  }

  private void addPlanes(final Group3D group) {
    for (final Object3D object : group.getObjects()) {
      if (object instanceof Group3D part) {
        addPlanes(part);
      } else if (object instanceof Plane plane) {
        addSquare(plane, plane.intersectionWith(new Ray(middle(), normal(plane))),
            plane.intersectionWith(new Ray(middle(), opposite(normal(plane)))));
      }
    }
  }

  private static Vector3D normal(final Plane plane) {
    return (Vector3D) plane.constructorArguments().get(1);
  }

  private static Vector3D opposite(final Vector3D v) {
    return new Vector3D(-v.x, -v.y, -v.z);
  }

  private Point3D middle() {
    final Point3D middle = bounds.getMin();
    middle.interpolate(bounds.getMax(), 0.5f);
    return middle;
  }

  /** A square about the foot of the middle of all else on a plane, to whichever side of the plane that is. */
  private void addSquare(final Plane plane, final Hit ahead, final Hit behind) {
    final Point3D foot = ahead.hits() ? ahead.getPoint() : behind.hits() ? behind.getPoint() : middle();
    final Vector3D n = normal(plane), u = new Vector3D(), v = new Vector3D();
    u.cross(n, Math.abs(n.x) < 0.7f ? new Vector3D(1, 0, 0) : new Vector3D(0, 1, 0));
    u.normalize();
    v.cross(n, u);
    final Point3D[] corners = new Point3D[4];
    for (int i = 0; i < corners.length; i++) {
      corners[i] = new Point3D(foot);
      corners[i].scaleAdd((i == 0 || i == 3 ? -0.4f : 0.4f) * size(), u, corners[i]);
      corners[i].scaleAdd((i < 2 ? -0.4f : 0.4f) * size(), v, corners[i]);
    }
    for (int i = 0; i < corners.length; i++) {
      lines.add(new Line(Kind.PLANE, corners[i], corners[(i + 1) % corners.length], plane.getColor().getRGB()));
    }
  }

  /** Size of all that is drawn. */
  private float size() {
    return Math.max(1, bounds.getMin().distance(bounds.getMax()));
  }

  private void addCamera() {
    final Projection projection = camera.getProjection();
    final Optional<FishEyeCap> cap = FishEyeCap.of(projection);
    final float w = projection.getWidth() / 2, h = projection.getHeight() / 2, length = Math.max(1, 0.1f * size());
    final float z = projection instanceof Orthographic ? 0 : cap.map(fishEye -> (float) fishEye.z(w)).orElse(-1f);
    add(Kind.AXIS_X, 0, 0, 0, length, 0, 0);
    add(Kind.AXIS_Y, 0, 0, 0, 0, length, 0);
    add(Kind.AXIS_Z, 0, 0, 0, 0, 0, length);
    addGrid(w, h, z);
    add(Kind.WINDOW, -w, -h, z, w, -h, z);
    add(Kind.WINDOW, w, -h, z, w, h, z);
    add(Kind.WINDOW, w, h, z, -w, h, z);
    add(Kind.WINDOW, -w, h, z, -w, -h, z);
    cap.ifPresent(this::addCap);
    for (final int sign : new int[] {-1, 1}) {
      addFrustum(sign * w, cap.isPresent() ? 0 : sign * h, z);
      addFrustum(cap.isPresent() ? 0 : -sign * w, sign * h, z);
    }
  }

  /** The line of sight through a point of the window. */
  private void addFrustum(final float x, final float y, final float z) {
    final float far = Math.max(1, 0.5f * size());
    if (camera.getProjection() instanceof Orthographic) {
      add(Kind.FRUSTUM, x, y, z, x, y, z - far);
    } else {
      add(Kind.FRUSTUM, 0, 0, 0, far * x, far * y, far * z);
    }
  }

  private void addGrid(final float w, final float h, final float z) {
    for (int i = step(W); i < W; i += step(W)) {
      final float x = 2 * w * i / W - w;
      add(Kind.GRID, x, -h, z, x, h, z);
    }
    for (int i = step(H); i < H; i += step(H)) {
      final float y = 2 * h * i / H - h;
      add(Kind.GRID, -w, y, z, w, y, z);
    }
  }

  /** Pixels between two lines of the grid: a power of two. */
  private static int step(final int pixels) {
    int step = 1;
    while (pixels / step > MOST_GRID_LINES) {
      step *= 2;
    }
    return step;
  }

  /** The rim of a fish-eye's cap, and two arcs across the cap. */
  private void addCap(final FishEyeCap cap) {
    final int parts = 48;
    final float z = (float) cap.z(cap.rim());
    for (int i = 0; i < parts; i++) {
      final double a = 2 * Math.PI * i / parts, b = 2 * Math.PI * (i + 1) / parts;
      add(Kind.WINDOW, (float) (cap.rim() * Math.cos(a)), (float) (cap.rim() * Math.sin(a)), z,
          (float) (cap.rim() * Math.cos(b)), (float) (cap.rim() * Math.sin(b)), z);
      final double s = 2 * cap.rim() * i / parts - cap.rim(), t = 2 * cap.rim() * (i + 1) / parts - cap.rim();
      add(Kind.WINDOW, (float) s, 0, (float) cap.z(s), (float) t, 0, (float) cap.z(t));
      add(Kind.WINDOW, 0, (float) s, (float) cap.z(s), 0, (float) t, (float) cap.z(t));
    }
  }

  private void addRay(final Ray ray, final Hit hit) {
    final Point3D end = hit.hits() ? hit.getPoint() : ray.pointAtParameter(size());
    lines.add(new Line(Kind.RAY, ray.getStartingPoint(), end, 0));
    if (hit.hits()) {
      final Point3D tip = hit.getPoint();
      final Vector3D n = hit.getNormal();
      n.scale(0.08f * size());
      tip.add(n);
      lines.add(new Line(Kind.NORMAL, hit.getPoint(), tip, 0));
    }
  }

  /** Adds a line of the camera's frame. */
  private void add(final Kind kind, final float x1, final float y1, final float z1, final float x2, final float y2,
      final float z2) {
    final Point3D from = new Point3D(x1, y1, z1), to = new Point3D(x2, y2, z2);
    camera.toSceneCoordinates(from);
    camera.toSceneCoordinates(to);
    lines.add(new Line(kind, from, to, 0));
  }
}
