package view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import primitives.Point3D;
import primitives.Vector3D;
import tracer.Ray;

class OrthographicTest implements ProjectionContract {

  @Override
  public Optics random(final Random random) {
    final float h = (float) Math.pow(10, 6 * random.nextDouble() - 3);
    final float aspect = (float) Math.pow(10, 2 * random.nextDouble() - 1);
    return new Optics(new Orthographic(h, aspect), (double) h / aspect, h, (x, y) -> new double[] {x, y, 0, 0, 0, -1});
  }

  @Test
  void aspectIsHeightByWidth() {
    final Orthographic projection = new Orthographic(3, 0.5f);
    assertEquals(3, projection.getHeight());
    assertEquals(6, projection.getWidth());
  }

  @Test
  void raysStartInTheWindowAboutTheCamera() {
    final Camera camera = new Camera(new Point3D(0, 0, 5), new Point3D(), new Vector3D(0, 1, 0));
    camera.setProjection(new Orthographic(2, 0.5f));
    final Ray lowerLeft = camera.getRayGenerator(4, 2).getRay(0, 0), upperRight = camera.getRayGenerator(4, 2).getRay(3, 1);
    assertEquals(new Point3D(-1.5f, -0.5f, 5), lowerLeft.getStartingPoint());
    assertEquals(new Point3D(1.5f, 0.5f, 5), upperRight.getStartingPoint());
    assertEquals(new Vector3D(0, 0, -1), lowerLeft.getDirection());
    assertEquals(new Vector3D(0, 0, -1), upperRight.getDirection());
  }

  @ParameterizedTest
  @CsvSource({"h,0,1", "h,-2,1", "h,NaN,1", "h,Infinity,1", "aspect,1,0", "aspect,1,-1", "aspect,1,NaN", "aspect,1,Infinity",
      "w,1e38,1e-30", "w,1e-38,1e30"})
  void rejectsSizesThatAreNotPositive(final String name, final float h, final float aspect) {
    final Exception wrong = assertThrows(IllegalArgumentException.class, () -> new Orthographic(h, aspect));
    assertEquals(true, wrong.getMessage().startsWith(name + " "), wrong.getMessage());
  }
}
