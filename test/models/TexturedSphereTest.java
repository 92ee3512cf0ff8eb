package models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.awt.Color;
import java.awt.image.BufferedImage;

import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

import materials.Texture;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import upnatray.Image;
import view.Camera;
import view.Orthographic;

/** A globe: the middle of the image faces +Z, its top is at +Y, and it is not mirrored when seen from outside. */
class TexturedSphereTest {

  private static final int W = 8;
  private static final int H = 4;
  private static final Point3D CENTRE = new Point3D(1, 2, 3);

  private static BufferedImage image() {
    final BufferedImage image = new BufferedImage(W, H, BufferedImage.TYPE_INT_ARGB);
    for (int column = 0; column < W; column++) {
      for (int row = 0; row < H; row++) {
        image.setRGB(column, row, color(column, row).getRGB());
      }
    }
    return image;
  }

  private static Color color(final int column, final int rowFromTop) {
    return new Color(20 * column, 30 * rowFromTop, 128, 200);
  }

  private static final Sphere GLOBE = new Sphere(CENTRE, 2, new Texture(image()));

  /** The ray from outside towards the centre, along −p. */
  private static Hit from(final Object3D object, final double x, final double y, final double z) {
    final Point3D R = new Point3D((float) (CENTRE.x + 9 * x), (float) (CENTRE.y + 9 * y), (float) (CENTRE.z + 9 * z));
    return object.intersectionWith(new Ray(R, CENTRE));
  }

  private static Color colorFrom(final Object3D object, final double x, final double y, final double z) {
    final Hit hit = from(object, x, y, z);
    return hit.getObject().getColorAt(hit);
  }

  /** The middle of each texel, where geometry puts it: longitude from the left, latitude from below. */
  @Test
  void eachTexelIsWhereGeometryPutsIt() {
    for (int column = 0; column < W; column++) {
      for (int row = 0; row < H; row++) {
        final double longitude = 2 * Math.PI * ((column + 0.5) / W - 0.5), latitude = Math.PI * (0.5 - (row + 0.5) / H);
        final double x = Math.cos(latitude) * Math.sin(longitude), z = Math.cos(latitude) * Math.cos(longitude);
        final Hit hit = from(GLOBE, x, Math.sin(latitude), z);
        assertEquals(color(column, row), GLOBE.getColorAt(hit), "texel " + column + ", " + row);
        assertEquals((column + 0.5) / W, hit.getTexCoord().x, 1e-6);
        assertEquals(1 - (row + 0.5) / H, hit.getTexCoord().y, 1e-6);
        assertEquals(hit.getNormal(), hit.getGeometricNormal());
      }
    }
  }

  @Test
  void theTopIsUpAndTheMiddleInFront() {
    assertEquals(0.5f, from(GLOBE, 0, 1, 0).getTexCoord().x);
    assertEquals(1, from(GLOBE, 0, 1, 0).getTexCoord().y, 1e-7);
    assertEquals(0, from(GLOBE, 0, -1, 0).getTexCoord().y, 1e-7);
    assertEquals(0.5f, from(GLOBE, 0, 0, 1).getTexCoord().x);
    assertEquals(0.75f, from(GLOBE, 1, 0, 0).getTexCoord().x, 1e-7f);
    assertEquals(0.25f, from(GLOBE, -1, 0, 0).getTexCoord().x, 1e-7f);
    assertEquals(0.5f, Math.abs(from(GLOBE, 0, 0, -1).getTexCoord().x - 0.5f), 1e-7f, "the seam is behind");
  }

  @Test
  void itTurnsAndMirrorsWithATransformation() {
    final Vector3f back = new Vector3f(-CENTRE.x, -CENTRE.y, -CENTRE.z), there = new Vector3f(CENTRE);
    final Object3D atOrigin = new AffineTransformation(new Vector3f(1, 1, 1), back, GLOBE);
    final Object3D turned = new AffineTransformation(new Vector3f(0, 1, 0), 90, there, atOrigin);
    assertEquals(colorFrom(GLOBE, 0.1, 0.2, 1), colorFrom(turned, 1, 0.2, -0.1));
    final Object3D mirrored = new AffineTransformation(new Vector3f(-1, 1, 1), there, atOrigin);
    assertEquals(colorFrom(GLOBE, 0.7, 0.2, 1), colorFrom(mirrored, -0.7, 0.2, 1));
  }

  @Test
  void itsColourIsTheMeanAndTheArgumentIsTheTexture() {
    assertEquals(new Color(70, 45, 128, 200), GLOBE.getColor());
    assertNull(GLOBE.getMaterial());
    assertEquals(Texture.class, GLOBE.constructorArguments().get(2).getClass());
    assertNull(new Sphere(CENTRE, 2, Color.RED).intersectionWith(new Ray(new Point3D(1, 2, 9), CENTRE)).getTexCoord());
  }

  /** The picture shows the colours of the hits, in a group with shapes of one colour too. */
  @Test
  void thePictureShowsTheTexture() {
    final Group3D group = new Group3D();
    group.addObject(GLOBE);
    group.addObject(new Sphere(new Point3D(3.5f, 2, 3), 0.5f, Color.RED));
    final Camera camera = new Camera(new Point3D(1, 2, 20), CENTRE, new Vector3D(0, 1, 0));
    camera.setProjection(new Orthographic(6, 1));
    final Image image = new Image(60, 60, Color.BLACK);
    image.synthesis(group, camera);
    int textured = 0;
    for (int m = 0; m < 60; m++) {
      for (int n = 0; n < 60; n++) {
        final Hit hit = group.intersectionWith(camera.getRayGenerator(60, 60).getRay(m, n));
        final int expected = hit.hits() ? hit.getObject().getColorAt(hit).getRGB() : Color.BLACK.getRGB();
        assertEquals(expected, image.getRGB(m, 59 - n), () -> hit.toString());
        textured += hit.getObject() == GLOBE ? 1 : 0;
      }
    }
    assertEquals(Math.PI * 400, textured, 30);
  }
}
