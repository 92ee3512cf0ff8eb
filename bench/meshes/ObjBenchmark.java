package meshes;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;

/** Reading an OBJ file of about 10 MB, from the file to the arrays: ten divided by the seconds is MB/s. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(2)
public class ObjBenchmark {

  private static final long SIZE = 10_000_000;

  private Path file;

  /**
   * Writes the file.
   *
   * @throws IOException if that cannot be done
   */
  @Setup
  public void write() throws IOException {
    file = Files.createTempFile("benchmark", ".obj");
    final SplittableRandom random = new SplittableRandom(1);
    long written = 0;
    int vertices = 0;
    try (BufferedWriter out = Files.newBufferedWriter(file)) {
      while (written < SIZE) {
        final StringBuilder text = new StringBuilder(String.format(Locale.ROOT, "v %.6f %.6f %.6f%n",
            random.nextDouble(-10, 10), random.nextDouble(-10, 10), random.nextDouble(-10, 10)));
        vertices++;
        if (vertices > 3) {
          for (int k = 0; k < 2; k++) {
            final int a = random.nextInt(1, vertices - 1);
            text.append("f ").append(a).append(' ').append(a + 1).append(' ').append(a + 2).append('\n');
          }
        }
        written += text.length();
        out.append(text);
      }
    }
  }

  /**
   * Deletes the file.
   *
   * @throws IOException if that cannot be done
   */
  @TearDown
  public void delete() throws IOException {
    Files.deleteIfExists(file);
  }

  /**
   * Reads the file.
   *
   * @return the mesh
   */
  @Benchmark
  public Object read() {
    return new ObjReader(file, false).read().mesh();
  }
}
