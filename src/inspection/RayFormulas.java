package inspection;

import java.util.ArrayList;
import java.util.List;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;
import view.Camera;
import view.Orthographic;
import view.Perspective;
import view.Projection;

/** The formulas of the assignment's projections, evaluated for one pixel. */
final class RayFormulas {

  private final Camera camera;
  private final Projection projection;
  private final int m;
  private final int n;
  private final int W;
  private final int H;
  private final List<Formula> formulas = new ArrayList<>();

  RayFormulas(final Camera camera, final int W, final int H, final int m, final int n) {
    this.camera = camera;
    this.projection = camera.getProjection();
    this.m = m;
    this.n = n;
    this.W = W;
    this.H = H;
  }

  List<Formula> of(final Ray ray) {
    final float w = projection.getWidth(), h = projection.getHeight();
    add("w", "", "", w);
    add("h", "", "", h);
    final double x = (m + 0.5) * w / W - w / 2, y = (n + 0.5) * h / H - h / 2;
    add("x", "(m + ½) · w / W − w / 2", centre(m, w, W), x);
    add("y", "(n + ½) · h / H − h / 2", centre(n, h, H), y);
    if (projection instanceof Orthographic) {
      orthographic((float) x, (float) y);
    } else if (projection instanceof Perspective) {
      final double z = projection.zAt(x, y);
      add("z", "", "", z);
      throughPoint((float) x, (float) y, (float) z);
    } else {
      FishEyeCap.of(projection).ifPresent(cap -> throughCap(cap, x, y, ray));
    }
    return formulas;
  }

  private static String centre(final int index, final float size, final int pixels) {
    final String s = Numbers.text(size);
    return "(" + index + " + 0.5) · " + s + " / " + pixels + " − " + s + " / 2";
  }

  private void orthographic(final float x, final float y) {
    final float z = (float) projection.zAt(x, y);
    add("z", "", "", z);
    final Point3D R = new Point3D(x, y, z);
    camera.toSceneCoordinates(R);
    formulas.add(new Formula("R", "V + x·i + y·j", sum(x, y, z), Numbers.text(R)));
    formulas.add(new Formula("v", "look", "", Numbers.text(camera.getLook())));
  }

  /** The ray from the eye through a point of the camera's frame. */
  private void throughPoint(final float x, final float y, final float z) {
    final Point3D Q = new Point3D(x, y, z);
    camera.toSceneCoordinates(Q);
    final Point3D V = camera.getPosition();
    formulas.add(new Formula("R", "V", "", Numbers.text(V)));
    formulas.add(new Formula("Q", "V + x·i + y·j + z·k", sum(x, y, z), Numbers.text(Q)));
    final Vector3D v = new Vector3D(x, y, z);
    camera.toSceneCoordinates(v);
    final String length = Numbers.text(Math.sqrt((double) v.x * v.x + (double) v.y * v.y + (double) v.z * v.z));
    final String numbers = Numbers.text(v) + " / " + length;
    v.normalize();
    formulas.add(new Formula("v", "(Q − R) / |Q − R|", numbers, Numbers.text(v)));
  }

  private String sum(final float x, final float y, final float z) {
    final StringBuilder sum = new StringBuilder(Numbers.text(camera.getPosition()));
    final float[] factors = {x, y, z};
    for (int axis = 0; axis < (z == 0 ? 2 : 3); axis++) {
      final Vector3D unit = new Vector3D(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
      camera.toSceneCoordinates(unit);
      sum.append(factors[axis] < 0 ? " − " : " + ").append(Numbers.text(Math.abs(factors[axis]))).append("·")
          .append(Numbers.text(unit));
    }
    return sum.toString();
  }

  private void throughCap(final FishEyeCap cap, final double x, final double y, final Ray ray) {
    final double rho = Math.hypot(x, y);
    add(cap.rimName(), "w / 2", Numbers.text(projection.getWidth()) + " / 2", cap.rim());
    add("ρ", "√(x² + y²)", "√(" + Numbers.text(x) + "² + " + Numbers.text(y) + "²)", rho);
    if (ray == Ray.NORAY) {
      final String comparison = Numbers.text(rho) + " > " + Numbers.text(cap.rim());
      formulas.add(new Formula("R, v", "ρ > " + cap.rimName(), comparison, "NORAY"));
      return;
    }
    final String numbers = "−√(" + Numbers.text(cap.radius2()) + " − " + Numbers.text(rho * rho) + ")";
    add("z", "−√(" + cap.radius2Name() + " − ρ²)", numbers, projection.zAt(x, y));
    throughPoint((float) x, (float) y, (float) projection.zAt(x, y));
  }

  private void add(final String symbol, final String general, final String numbers, final double value) {
    formulas.add(new Formula(symbol, general, numbers, Numbers.text(value)));
  }
}
