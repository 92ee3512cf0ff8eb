package upnatray;

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;

import materials.AshikhminShirley;
import materials.Beckmann;
import materials.Blinn;
import materials.GGX;
import materials.IdealConductor;
import materials.IdealDielectric;
import materials.Lambertian;
import materials.Material;
import materials.OrenNayar;
import materials.PhongLafortune;
import materials.ReflectiveCookTorrance;
import materials.SpecularRays;
import materials.SurfaceInteraction;
import materials.TransmissiveCookTorrance;
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
import radiometry.ReflectanceRGB;

/** Time to shade one point under one light with each material; {@code -prof gc} adds the bytes allocated. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(2)
public class MaterialBenchmark {

  private static final int POINTS = 1 << 10;

  /** Kind of the material. */
  @Param({"lambertian", "oren-nayar", "phong", "ashikhmin", "cook-torrance", "transmissive", "mirror", "glass"})
  public String kind;

  private final SurfaceInteraction interaction = new SurfaceInteraction();
  private final SpecularRays specular = new SpecularRays();
  private final double[] vectors = new double[6 * POINTS];
  private Material material;

  /** Makes the material, and directions of viewers and lights above the surface. */
  @Setup
  public void make() {
    material = material(kind);
    final SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < vectors.length; i += 3) {
      final double z = random.nextDouble(0.05, 1), angle = random.nextDouble(2 * Math.PI), s = Math.sqrt(1 - z * z);
      vectors[i] = s * Math.cos(angle);
      vectors[i + 1] = s * Math.sin(angle);
      vectors[i + 2] = z;
    }
  }

  private static Material material(final String kind) {
    final ReflectanceRGB half = new ReflectanceRGB(0.5f, 0.4f, 0.3f), low = new ReflectanceRGB(0.2f, 0.2f, 0.2f);
    return switch (kind) {
      case "lambertian" -> new Lambertian(half);
      case "oren-nayar" -> new OrenNayar(half, 0.4f);
      case "phong" -> new PhongLafortune(half, low, new Blinn(20));
      case "ashikhmin" -> new AshikhminShirley(half, low, new Blinn(20));
      case "cook-torrance" -> new ReflectiveCookTorrance(half, low, new Beckmann(0.3f));
      case "transmissive" -> new TransmissiveCookTorrance(half, 1.5f, 1, new GGX(0.3f));
      case "mirror" -> new IdealConductor(half);
      default -> new IdealDielectric(half, 1.5f, 1);
    };
  }

  /**
   * Shades the points.
   *
   * @return something that depends on all results
   */
  @Benchmark
  @OperationsPerInvocation(POINTS)
  public double shade() {
    double sum = 0;
    for (int i = 0; i < vectors.length; i += 6) {
      interaction.setView(0, 0, 1, vectors[i], vectors[i + 1], vectors[i + 2], true);
      if (material.scatters()) {
        interaction.setIncident(vectors[i + 3], vectors[i + 4], vectors[i + 5]);
        interaction.setIrradiance(1, 1, 1);
        material.scatter(interaction);
        sum += interaction.radianceR();
      }
      sum += material.specular(interaction.cosineOut(), true, specular) ? specular.reflectedR() : 0;
    }
    return sum;
  }
}
