package upnatray;

import java.awt.Color;
import java.util.concurrent.TimeUnit;

import models.Group3D;
import models.TriangularMesh;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import rendering.RenderSettings;
import view.Camera;

/** How the cost of a picture of a mesh, and of building its tree, grows with its number of triangles. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(value = 1, jvmArgsAppend = "-Xmx4g")
public class MeshBenchmark {

  /** Number of triangles, at least. */
  @Param({"1000", "10000", "100000", "1000000", "4000000"})
  public int triangles;

  private final Image image = new Image(512, 512, Color.BLACK);
  private final Camera camera = BenchmarkScene.camera();
  private final Group3D scene = new Group3D();
  private float[] coordinates;
  private int[] corners;

  /** Makes the mesh. */
  @Setup
  public void make() {
    coordinates = BenchmarkScene.coordinates(triangles);
    corners = BenchmarkScene.corners(triangles);
    scene.addObject(TriangularMesh.of(coordinates, corners, Color.ORANGE));
  }

  /**
   * A picture of 512 × 512 pixels by one thread.
   *
   * @return whether it came to an end
   */
  @Benchmark
  public boolean picture() {
    return image.synthesis(scene, camera, RenderSettings.STANDARD.withThreads(1));
  }

  /**
   * Building the tree, by all cores.
   *
   * @return the mesh
   */
  @Benchmark
  public TriangularMesh build() {
    return TriangularMesh.of(coordinates, corners, Color.ORANGE);
  }
}
