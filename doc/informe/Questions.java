import java.nio.file.Path;

import models.Cost;
import scenes.SceneFile;
import scenes.SceneReader;
import tracer.RayGenerator;

/** How many objects, triangles or steps a ray asks on average in the scenes that are the arguments, by single rays. */
public final class Questions {

  private static final int SIZE = 100;

  private Questions() {
  }

  /** Prints a line for each scene. */
  public static void main(final String... arguments) {
    for (final String name : arguments) {
      final SceneFile scene = SceneReader.read(Path.of(name)).scene().orElseThrow();
      final RayGenerator rays = scene.camera().getRayGenerator(SIZE, SIZE);
      long cost = 0;
      for (int n = 0; n < SIZE; n++) {
        for (int m = 0; m < SIZE; m++) {
          cost += Cost.of(scene.objects(), rays.getRay(m, n));
        }
      }
      System.out.printf("%s: %.2f%n", name, cost / (double) (SIZE * SIZE));
    }
  }
}
