package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.awt.Color;
import java.util.List;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import acceleration.RayTile;
import materials.Lambertian;
import materials.Material;
import primitives.Point3D;
import radiometry.ReflectanceRGB;
import tracer.Hit;
import tracer.Ray;

/** The colour and the material of an object, and of objects derived from it. */
class AppearanceTest {

  private static final Material GREY = new Lambertian(new ReflectanceRGB(0.5f, 0.5f, 0.5f));

  /** An object that nothing hits. */
  private static final class Ghost extends Object3D {

    Ghost(final Material material) {
      super(material);
    }

    Ghost(final Color color, final Material material) {
      super(color, material);
    }

    Ghost(final Color color) {
      super(color);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      return Hit.NOHIT;
    }
  }

  @Test
  void materialStandsForTheColourUnlessThereIsOne() {
    assertEquals(GREY.getColor(), new Ghost(GREY).getColor());
    assertEquals(Color.RED, new Ghost(Color.RED, GREY).getColor());
    assertEquals(Color.RED, new Ghost(Color.RED).getColorAt(Hit.NOHIT));
    assertSame(GREY, new Ghost(Color.RED, GREY).getMaterial());
    assertNull(new Ghost(Color.RED).getMaterial());
  }

  @Test
  void appearancesAreEqualIfColourMaterialAndTextureAre() {
    final Material other = new Lambertian(new ReflectanceRGB(0.5f, 0.5f, 0.5f));
    final List<Appearance> all = List.of(Appearance.of(Color.RED), Appearance.of(Color.GREEN), Appearance.of(GREY),
        new Appearance(GREY.getColor(), other), Appearance.NONE);
    for (final Appearance one : all) {
      final Appearance same = new Appearance(one.color(), one.material(), one.texture());
      assertEquals(one, same);
      assertEquals(one.hashCode(), same.hashCode());
      for (final Appearance another : all) {
        assertEquals(one == another, one.equals(another), one + ", " + another);
      }
    }
  }

  @Test
  void transformationHasTheMaterialOfItsObjectAndAGroupNone() {
    assertSame(GREY, new AffineTransformation(new Vector3f(1, 2, 3), new Ghost(GREY)).getMaterial());
    final Group3D group = new Group3D();
    group.addObject(new Ghost(GREY));
    assertNull(group.getMaterial());
  }

  @Test
  void rejectsWhatIsMissing() {
    assertThrows(IllegalArgumentException.class, () -> new Ghost((Color) null));
    assertThrows(IllegalArgumentException.class, () -> new Ghost((Material) null));
    assertThrows(IllegalArgumentException.class, () -> new Ghost(null, GREY));
    assertThrows(IllegalArgumentException.class, () -> new Ghost(Color.RED, null));
  }

  /** A chequered ball, white on one side and black on the other. */
  private static final class Chequered extends Sphere {

    Chequered() {
      super(new Point3D(), 1, Color.WHITE);
    }

    @Override
    public Color getColorAt(final Hit hit) {
      return hit.pointX() > 0 ? Color.WHITE : Color.BLACK;
    }
  }

  @Test
  void patternOfASubclassIsPainted() {
    assertPainted(new Chequered());
  }

  @Test
  void patternOfATransformedObjectIsPainted() {
    assertPainted(new AffineTransformation(new Vector3f(1, 1.5f, 1), new Chequered()));
    assertPainted(new AffineTransformation(new Vector3f(1, 2, 1),
        new AffineTransformation(new Vector3f(1, 0.5f, 1), new Chequered())));
  }

  private static void assertPainted(final Object3D chequered) {
    final Group3D scene = new Group3D();
    scene.addObject(chequered);
    final RayTile rays = new RayTile();
    rays.open(2, 1);
    rays.put(0, -0.5, 0, 5, 0, 0, -1);
    rays.put(1, 0.5, 0, 5, 0, 0, -1);
    rays.close();
    final TileHits hits = new TileHits(rays);
    hits.clear();
    scene.closestHits(rays, hits);
    assertEquals(Color.BLACK.getRGB(), hits.argb(0));
    assertEquals(Color.WHITE.getRGB(), hits.argb(1));
  }
}
