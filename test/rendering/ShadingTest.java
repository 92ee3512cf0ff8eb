package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;

import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;

import lights.LightGroup;
import lights.Omnidirectional;
import models.Group3D;
import models.Plane;
import primitives.Point3D;
import primitives.Vector3D;
import radiometry.SpectrumRGB;
import tracer.Hit;
import tracer.Ray;

class ShadingTest {

  private static final Ray DOWN = new Ray(new Point3D(0, 3, 0), new Vector3D(0, -1, 0));

  private static final SpectrumRGB WHITE = new SpectrumRGB(1 / 3f, 1 / 3f, 1 / 3f);
  private static final LightGroup LAMPS = new LightGroup(new Omnidirectional(new Point3D(4, 5, 6), WHITE, 200),
      new Omnidirectional(new Point3D(0, 0.5f, 0), WHITE, 5));

  private static int shade(final Shading shading, final Vector3D normal, final Color color) {
    final Plane plane = new Plane(new Point3D(), normal, color);
    return shading.argb(DOWN, new Hit(3, new Point3D(), normal, plane));
  }

  @Test
  void plainIsTheColourOfTheObject() {
    final Color color = new Color(1, 2, 3, 4);
    assertEquals(color.getRGB(), shade(Shading.PLAIN, new Vector3D(1, 1, 0), color));
  }

  @Test
  void aSurfaceThatFacesTheRayShowsItsColour() {
    final Color color = new Color(200, 100, 51, 17);
    assertEquals(color.getRGB(), shade(Shading.FACING, new Vector3D(0, 1, 0), color));
  }

  @Test
  void facingIsTimesTheCosineAndKeepsAlpha() {
    final Vector3D sixtyDegrees = new Vector3D((float) Math.sqrt(3), 1, 0);
    assertEquals(new Color(100, 50, 26, 17).getRGB(), shade(Shading.FACING, sixtyDegrees, new Color(200, 100, 51, 17)));
    final Vector3D threeFourFive = new Vector3D(4, 3, 0);
    assertEquals(new Color(153, 60, 0, 255).getRGB(), shade(Shading.FACING, threeFourFive, new Color(255, 100, 0)));
  }

  @Test
  void bothSidesOfASurfaceAreShadedAlike() {
    final Vector3D normal = new Vector3D(4, 3, 0), turned = new Vector3D(-4, -3, 0);
    final Color color = new Color(12, 200, 77);
    assertEquals(shade(Shading.FACING, normal, color), shade(Shading.FACING, turned, color));
  }

  @Test
  void aSurfaceSeenFromItsEdgeIsBlack() {
    assertEquals(new Color(0, 0, 0, 99).getRGB(), shade(Shading.FACING, new Vector3D(1, 0, 0), new Color(200, 100, 51, 99)));
  }

  /** The laws of all shadings, for those of the library. */
  @Nested
  class Plain implements ShadingContract {
    @Override
    public Shading shading(final Group3D scene) {
      return Shading.PLAIN;
    }
  }

  @Nested
  class Facing implements ShadingContract {
    @Override
    public Shading shading(final Group3D scene) {
      return Shading.FACING;
    }
  }

  @Nested
  class Objects implements ShadingContract {
    @Override
    public Shading shading(final Group3D scene) {
      return new ObjectColours(scene);
    }
  }

  @Nested
  class Lit implements ShadingContract {
    @Override
    public Shading shading(final Group3D scene) {
      return new Illumination(scene, LAMPS, 3, Color.BLUE);
    }
  }

  @Nested
  class ByLight implements ShadingContract {
    @Override
    public Shading shading(final Group3D scene) {
      return new LightColours(new Illumination(scene, LAMPS, 3, Color.BLUE));
    }
  }
}
