package primitives;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;

import javax.vecmath.Point3f;
import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;

class PointAndVectorTest {

  @Test
  void withoutArgumentsTheyAreZero() {
    assertEquals("(0.0, 0.0, 0.0)", new Point3D().toString());
    assertEquals("(0.0, 0.0, 0.0)", new Vector3D().toString());
  }

  @Test
  void threeNumbersAreTheCoordinates() {
    assertEquals("(1.5, -2.0, 300.0)", new Point3D(1.5f, -2, 300).toString());
    assertEquals("(1.5, -2.0, 300.0)", new Vector3D(1.5f, -2, 300).toString());
  }

  @Test
  void theyAreTuplesOfVecmath() {
    assertInstanceOf(Point3f.class, new Point3D());
    assertInstanceOf(Vector3f.class, new Vector3D());
    assertEquals(5, new Vector3D(0, 3, 4).length());
    assertEquals(5, new Point3D(1, 1, 1).distance(new Point3D(1, 4, 5)));
  }

  @Test
  void copiesAreIndependent() {
    final Point3D P = new Point3D(1, 2, 3), copyOfP = new Point3D(P);
    final Vector3D v = new Vector3D(1, 2, 3), copyOfV = new Vector3D(v);
    assertEquals(P, copyOfP);
    assertEquals(v, copyOfV);
    assertNotSame(P, copyOfP);
    P.set(9, 9, 9);
    v.negate();
    assertEquals(new Point3D(1, 2, 3), copyOfP);
    assertEquals(new Vector3D(1, 2, 3), copyOfV);
  }
}
