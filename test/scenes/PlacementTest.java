package scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Random;

import javax.vecmath.AxisAngle4d;
import javax.vecmath.Matrix3d;
import javax.vecmath.Vector3d;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import models.Object3D;
import models.Sphere;
import primitives.Point3D;
import primitives.Vector3D;
import tracer.Hit;
import tracer.Ray;
import trials.Trials;

class PlacementTest {

  @TempDir
  Path folder;

  /** The placement that the elements of an object give. */
  private static Placement placement(final String elements) throws XmlSyntaxException {
    final Problems problems = new Problems(new SourceText("f", "<object>" + elements + "</object>"));
    final MarkupReader markup = new MarkupReader(problems);
    final Element object = markup.read();
    final Placement placement = new PlacementReader(new Values(problems, markup.comments())).read(object);
    assertEquals("[]", problems.inFileOrder().toString());
    return placement;
  }

  private static String element(final String name, final Vector3d v) {
    return String.format(Locale.ROOT, "<%s>%.9g %.9g %.9g</%s>", name, v.x, v.y, v.z, name);
  }

  private static Vector3d vector(final Random random) {
    return new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
  }

  private static void assertClose(final Vector3d expected, final Vector3D actual) {
    final Vector3d difference = new Vector3d(actual.x, actual.y, actual.z);
    difference.sub(expected);
    assertTrue(difference.length() < 1e-6, expected + " " + actual);
  }

  /** The table of the language, row by row: the computed axes by its products. */
  @ParameterizedTest
  @CsvSource({"i, j, k, main aux", "i, k, j, aux main", "j, i, k, aux main", "j, k, i, main aux", "k, i, j, main "
      + "aux", "k, j, i, aux main"})
  void aimingComputesTheAxesByTheTable(final char main, final char aux, final char third, final String product) {
    Trials.of(200, random -> {
      final Vector3d m = vector(random), a = vector(random), t = new Vector3d();
      final Placement placement = placement(element(main + "Vector", m) + element(aux + "auxVector", a));
      t.cross(product.startsWith("main") ? m : a, product.startsWith("main") ? a : m);
      m.normalize();
      t.normalize();
      assertClose(m, direction(placement, main));
      assertClose(t, direction(placement, third));
      final Vector3D i = placement.direction(1, 0, 0), j = placement.direction(0, 1, 0), k = placement.direction(0, 0, 1);
      final Vector3D x = new Vector3D();
      x.cross(i, j);
      assertClose(new Vector3d(k.x, k.y, k.z), x);
    });
  }

  private static Vector3D direction(final Placement placement, final char axis) {
    return placement.direction(axis == 'i' ? 1 : 0, axis == 'j' ? 1 : 0, axis == 'k' ? 1 : 0);
  }

  @Test
  void firstMainVectorAndFirstAuxiliaryOfItsPairCount() throws XmlSyntaxException {
    final String all = "<kVector>0 1 0</kVector><jVector>1 1 1</jVector><iVector>0 0 -1</iVector>"
        + "<kauxVector>0 1 0</kauxVector><jauxVector>0 1 0</jauxVector>";
    final Placement placement = placement(all);
    assertClose(new Vector3d(0, 0, -1), placement.direction(1, 0, 0));
    assertClose(new Vector3d(0, 1, 0), placement.direction(0, 1, 0));
  }

  @Test
  void scaleThenAimingThenRotationThenTranslation() throws XmlSyntaxException {
    final Placement placement = placement("<translation>10 0 0</translation><rotationAngle>90</rotationAngle>"
        + "<iVector>0 1 0</iVector><jauxVector>-1 0 0</jauxVector>");
    final Point3D p = placement.point(2, 0, 0);
    assertEquals(10, p.x, 1e-6);
    assertEquals(2, p.y, 1e-6);
    final Point3D q = placement.point(0, 2, 0);
    assertEquals(10, q.x, 1e-6);
    assertEquals(0, q.y, 1e-6);
    assertEquals(2, q.z, 1e-6);
  }

  @Test
  void nothingGivenIsNothingDone() throws XmlSyntaxException {
    final Object3D sphere = new Sphere(new Point3D(), 1, Color.RED);
    assertSame(sphere, placement("").applied(sphere));
    assertSame(sphere, placement("<rotationAngle>0</rotationAngle><rotationAxis>0 0 0</rotationAxis><scaleFactors>1 1 "
        + "1</scaleFactors>")
        .applied(sphere));
    assertSame(sphere, placement("<rotationAngle>720</rotationAngle>").applied(sphere));
  }

  /** The one rotation of a transformation has the effect of both, also where their angles add up to nearly 0° or 180°. */
  @Test
  void oneAxisAndAngleStandForBothTurns() {
    Trials.of(3000, random -> {
      final Rotation first = turn(random), second = turn(random);
      final Rotation both = second.after(first);
      final Matrix3d product = new Matrix3d();
      product.mul(second.matrix(), first.matrix());
      assertTrue(product.epsilonEquals(both.matrix(), 1e-15));
      final Matrix3d again = new Matrix3d();
      again.set(new AxisAngle4d(both.axis().x, both.axis().y, both.axis().z, Math.toRadians(both.degrees())));
      assertTrue(product.epsilonEquals(again, 5e-7), product + "" + again);
    });
  }

  private static Rotation turn(final Random random) {
    final float[] axis = {random.nextInt(3) - 1, random.nextInt(3) - 1, 1};
    final double near = Math.pow(10, -8 * random.nextDouble()) * (random.nextBoolean() ? 1 : -1);
    final float degrees = (float) (random.nextInt(5) * 90 - 180 + (random.nextBoolean() ? near : 0));
    return Rotation.about(random.nextBoolean() ? axis : new float[] {0, 1, 0},
        random.nextInt(4) == 0 ? random.nextFloat() * 360 : degrees);
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|',
      value = {"sphere|<radius>1.5</radius>", "box|<width>1</width><height>2</height><depth>3</depth>",
    "plane|<point>0 0.5 0.25</point><normal>1 2 -1</normal>", "cylinder|<radius>0.75</radius><Axislength>2</Axislength>",
    "capsule|<A>1 0 0</A><B>0 1 -1</B><radius>0.5</radius>", "capsule|<A>1 0 0</A><B>1 0 0</B><radius>0.5</radius>",
    "torus|<rotationalRadius>1.5</rotationalRadius><circunferenceRadius>0.5</circunferenceRadius>",
    "ellipsoid|<a>1</a><b>1.5</b><c>0.5</c>"})
  void aShapeBuiltAtItsPlaceIsTheShapeTransformed(final String type, final String values) {
    final SceneFiles files = new SceneFiles(folder);
    final String rigid = "<translation>0.5 -1 0.25</translation><rotationAxis>1 2 "
        + "3</rotationAxis><rotationAngle>40</rotationAngle>"
        + "<jVector>1 1 0</jVector><kauxVector>0 1 5</kauxVector>";
    final Object3D built = object(files, type, values, rigid);
    final Object3D transformed = object(files, type, values, rigid + "<scaleFactors>1 1.000001 1</scaleFactors>");
    final int[] hits = new int[1];
    Trials.of(500, random -> {
      final Point3D eye = new Point3D(5, random.nextFloat() * 4 - 2, random.nextFloat() * 4 - 2);
      final Point3D target = new Point3D(random.nextFloat() * 2 - 1, random.nextFloat() * 3 - 2.5f,
          random.nextFloat() * 2 - 1);
      final Hit a = built.intersectionWith(new Ray(eye, target)), b = transformed.intersectionWith(new Ray(eye, target));
      if (a.hits() && b.hits() && Math.abs(a.getNormal().dot(new Ray(eye, target).getDirection())) > 0.1) {
        assertEquals(a.getT(), b.getT(), 1e-3);
        assertTrue(a.getNormal().dot(b.getNormal()) > 0.99, a + " " + b);
        hits[0]++;
      }
    });
    assertTrue(hits[0] > 50, type + " " + hits[0]);
  }

  @Test
  void factorsOfScaleGoAlongTheAxesOfTheModel() {
    final SceneFiles files = new SceneFiles(folder);
    final Object3D sphere = object(files, "sphere", "<radius>1</radius>", "<scaleFactors>1 3 1</scaleFactors>"
        + "<jVector>1 0 0</jVector><kauxVector>0 0 1</kauxVector><translation>0 0 7</translation>");
    final Hit hit = sphere.intersectionWith(new Ray(new Point3D(10, 0, 7), new Vector3D(-1, 0, 0)));
    assertEquals(7, hit.getT(), 1e-5);
    assertEquals(1, hit.getNormal().x, 1e-6);
    final Object3D mirrored = object(files, "capsule", "<A>0 0 0</A><B>4 0 "
        + "0</B><radius>1</radius>", "<scaleFactors>-1 1 1</scaleFactors>");
    assertEquals(5, mirrored.intersectionWith(new Ray(new Point3D(-10, 0, 0), new Vector3D(1, 0, 0))).getT(), 1e-5);
  }

  @Test
  void aMeshIsReadOnceAndSharedByItsObjects() {
    final SceneFiles files = new SceneFiles(folder);
    files.write("t.obj", "v 0 -9 -9\nv 0 9 -9\nv 0 0 9\nf 1 2 3\nf 1 1 2\n");
    final String object = "</object><object><modelId>ball</modelId><color>%s</color><translation>%d 0 0</translation>";
    final ReadResult reading = files.read(SceneFiles.SOUND.replace("type=\"sphere\"", "type=\"mesh\"")
        .replace("<radius>1</radius>", "<objFile>t.obj</objFile>").replace("</color>", "</color>"
            + String.format(object, "0 0 1", 2)
            + String.format(object, "0 0 1", 4)));
    assertEquals(1, reading.problems().size());
    final Ray ray = new Ray(new Point3D(9, 0, 0), new Vector3D(-1, 0, 0));
    final Hit hit = reading.scene().orElseThrow().objects().intersectionWith(ray);
    assertEquals(5, hit.getT(), 1e-6);
    assertEquals(Color.BLUE, hit.getObject().getColor());
    final Ray back = new Ray(new Point3D(-9, 0, 0), new Vector3D(1, 0, 0));
    assertEquals(Color.RED, reading.scene().orElseThrow().objects().intersectionWith(back).getObject().getColor());
  }

  private static Object3D object(final SceneFiles files, final String type, final String values, final String placement) {
    final String text = SceneFiles.SOUND.replace("<model id=\"ball\" type=\"sphere\">\n      <radius>1</radius>",
        "<model id=\"ball\" type=\"" + type + "\">\n      " + values).replace("</color>", "</color>" + placement);
    final ReadResult reading = files.read(text);
    assertEquals("[]", reading.problems().toString());
    return reading.scene().orElseThrow().objects();
  }
}
