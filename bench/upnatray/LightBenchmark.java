package upnatray;

import java.awt.Color;
import java.util.concurrent.TimeUnit;

import lights.Directional;
import lights.Light;
import lights.LightGroup;
import lights.Omnidirectional;
import lights.Spot;
import models.Group3D;
import models.Plane;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.SpectrumRGB;
import rendering.Illumination;
import rendering.RenderSettings;
import view.Camera;

/** Time of a pixel of a lit picture, a mesh of 100,000 triangles above a floor, with each kind of light. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(2)
public class LightBenchmark {

  private static final int SIZE = 256;

  /** Kind of the light; a picture without any shows what the first hits cost. */
  @Param({"none", "omnidirectional", "spot", "directional"})
  public String light;

  private final Image image = new Image(SIZE, SIZE, Color.BLACK);
  private final Group3D scene = new Group3D();
  private final Camera camera = BenchmarkScene.camera();
  private RenderSettings settings;

  /** Makes the scene and its light. */
  @Setup
  public void make() {
    scene.addObject(BenchmarkScene.mesh(100_000));
    scene.addObject(new Plane(new Point3D(0, -1, 0), new Vector3D(0, 1, 0), Color.GRAY));
    final LightGroup lights = light.equals("none") ? new LightGroup() : new LightGroup(light(light));
    settings = RenderSettings.STANDARD.withThreads(1).withShading(new Illumination(scene, lights, 0, Color.BLACK));
  }

  private static Light light(final String kind) {
    final Point3D at = new Point3D(3, 5, 2), origin = new Point3D();
    final SpectrumRGB white = new SpectrumRGB(0.25f, 0.5f, 0.25f);
    return switch (kind) {
      case "spot" -> new Spot(at, origin, 40, white, 500);
      case "directional" -> new Directional(at, origin, 5, white, 500);
      default -> new Omnidirectional(at, white, 500);
    };
  }

  /**
   * A lit picture by one thread.
   *
   * @return whether it came to an end
   */
  @Benchmark
  @OperationsPerInvocation(SIZE * SIZE)
  public boolean pixel() {
    return image.synthesis(scene, camera, settings);
  }
}
