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
 * A three-dimensional line drawing of a scene and its camera: the camera's axes, the window of the projection with its grid
 * of pixels, the bounding boxes of the objects and the ray of a pixel.
 */
public final class Wireframe {

  /** Maximum number of boxes: more would be illegible. */
  private static final int MAX_BOXES = 2000;

  /** Maximum number of grid lines in each direction; a cell of the grid may stand for several pixels. */
  private static final int MAX_GRID_LINES = 16;

  /** The kinds of lines. */
  public enum Kind {
    /** The camera's x axis. */
    AXIS_X,
    /** The camera's y axis. */
    AXIS_Y,
    /** The camera's z axis, opposite to the viewing direction. */
    AXIS_Z,
    /** The border of the window of the projection. */
    WINDOW,
    /** The grid of pixels in the window. */
    GRID,
    /** Lines of sight through the corners of the window, or through the rim of a fish-eye. */
    FRUSTUM,
    /** The bounding box of an object. */
    BOX,
    /** The bounding box of an object that contains the camera, such as a sky. */
    AROUND,
    /** A square patch of an infinite plane. */
    PLANE,
    /** The ray of the pinned pixel, up to its hit. */
    RAY,
    /** The normal at the hit. */
    NORMAL,
    /** The shadow ray of a light that is not blocked. */
    SHADOW_LIT,
    /** The shadow ray of a blocked light, up to what blocks it. */
    SHADOW_BLOCKED,
    /** An ideally reflected ray. */
    REFLECTED,
    /** An ideally refracted ray. */
    REFRACTED,
    /** The ray that is selected in the inspector. */
    SELECTED
  }

  /**
   * A line between two points of the scene.
   *
   * @param kind the kind of line
   * @param from one end
   * @param to the other end
   * @param argb colour of the object of a box or plane; 0 if it has none, and for all other kinds
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
   * Draws a scene.
   *
   * @param scene the scene, whose camera has a projection
   * @param W width of the picture in pixels, at least 1
   * @param H height of the picture in pixels, at least 1
   * @return the lines, without a ray
   * @throws IllegalArgumentException if the scene is null, or W or H is not positive
   */
  public static List<Line> of(final SceneFile scene, final int W, final int H) {
    return of(scene, W, H, Ray.NORAY, Hit.NOHIT);
  }

  /**
   * Draws a scene with a ray.
   *
   * @param scene the scene, whose camera has a projection
   * @param W width of the picture in pixels, at least 1
   * @param H height of the picture in pixels, at least 1
   * @param ray the ray; {@link Ray#NORAY} for none
   * @param hit its hit; {@link Hit#NOHIT} for none
   * @return the lines
   * @throws IllegalArgumentException if an argument is null, or W or H is not positive
   */
  public static List<Line> of(final SceneFile scene, final int W, final int H, final Ray ray, final Hit hit) {
    final Wireframe wireframe = new Wireframe(scene, W, H);
    wireframe.addBoxes(scene.objects());
    wireframe.bounds = bounds(wireframe.lines).union(wireframe.bounds);
    wireframe.addPlanes(scene.objects());
    wireframe.addCamera();
    if (notNull("ray", ray) != Ray.NORAY) {
      wireframe.addRay(ray, notNull("hit", hit));
    }
    return List.copyOf(wireframe.lines);
  }

  /**
   * The bounding box of the interesting part of a drawing: without the lines of sight, and without objects that contain the
   * camera unless there are no others.
   *
   * @param lines a drawing
   * @return the box
   * @throws IllegalArgumentException if the lines are null
   */
  public static BoundingBox bounds(final List<Line> lines) {
    final boolean noOthers = notNull("lines", lines).stream().noneMatch(line -> line.kind() == Kind.BOX);
    BoundingBox box = BoundingBox.EMPTY;
    for (final Line line : lines) {
      if (line.kind() != Kind.FRUSTUM && (noOthers || line.kind() != Kind.AROUND)) {
        box = box.union(new BoundingBox(line.from(), line.from())).union(new BoundingBox(line.to(), line.to()));
      }
    }
    return box;
  }

  private void addBoxes(final Group3D group) {
    for (final Object3D object : group.getMembers()) {
      final BoundingBox box = boxOf(object);
      if (box != null && box.isFinite() && lines.size() < MAX_BOXES * 12) {
        addBox(box, object.getColor() == null ? 0 : object.getColor().getRGB());
      }
    }
  }

  /** The bounding box of an object; null if it throws, which the inspector reports. */
  private static BoundingBox boxOf(final Object3D object) {
    try {
      return object.getBoundingBox();
    } catch (final RuntimeException | StackOverflowError failed) {
      return null;
    }
  }

  /** Adds the edges: each joins two corners whose numbers differ in one bit, which stands for a coordinate. */
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
    for (final Object3D object : group.getMembers()) {
      if (object instanceof Plane plane) {
        addSquare(plane, plane.intersectionWith(new Ray(centre(), normal(plane))),
            plane.intersectionWith(new Ray(centre(), opposite(normal(plane)))));
      }
    }
  }

  private static Vector3D normal(final Plane plane) {
    return (Vector3D) plane.constructorArguments().get(1);
  }

  private static Vector3D opposite(final Vector3D v) {
    return new Vector3D(-v.x, -v.y, -v.z);
  }

  private Point3D centre() {
    final Point3D centre = bounds.getMin();
    centre.interpolate(bounds.getMax(), 0.5f);
    return centre;
  }

  /** Adds a square patch of a plane around the projection of the scene's centre, on whichever side that lies. */
  private void addSquare(final Plane plane, final Hit ahead, final Hit behind) {
    final Point3D foot = ahead.hits() ? ahead.getPoint() : behind.hits() ? behind.getPoint() : centre();
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

  /** Diameter of the drawing. */
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

  /** Adds the line of sight through a point of the window. */
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

  /** Number of pixels between two grid lines, a power of two. */
  private static int step(final int pixels) {
    int step = 1;
    while (pixels / step > MAX_GRID_LINES) {
      step *= 2;
    }
    return step;
  }

  /** Adds the rim of a fish-eye's cap and two arcs across it. */
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

  /** Adds a line given in the camera's frame. */
  private void add(final Kind kind, final float x1, final float y1, final float z1, final float x2, final float y2,
      final float z2) {
    final Point3D from = new Point3D(x1, y1, z1), to = new Point3D(x2, y2, z2);
    camera.toSceneCoordinates(from);
    camera.toSceneCoordinates(to);
    lines.add(new Line(kind, from, to, 0));
  }
}
