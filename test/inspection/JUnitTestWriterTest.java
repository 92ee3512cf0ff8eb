package inspection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.StringWriter;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import javax.vecmath.TexCoord2f;
import javax.vecmath.Vector3f;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.opentest4j.AssertionFailedError;

import materials.Texture;
import models.AffineTransformation;
import models.Object3D;
import models.Sphere;
import models.TriangularMesh;
import primitives.Point3D;
import primitives.Vector3D;
import scenes.SceneFile;
import scenes.SceneReader;
import tracer.Hit;
import tracer.Ray;

class JUnitTestWriterTest {

  private static final int W = 48;
  private static final int H = 36;

  @TempDir
  Path folder;

  /** Compiles methods as members of a class in its own package, and instantiates it. */
  private Object compiled(final Iterable<String> methods) throws Exception {
    final Path source = folder.resolve("CopiedTest.java");
    Files.writeString(source, "package copied;\n\npublic class CopiedTest {\n\n" + String.join("\n", methods) + "}\n");
    final JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    final StringWriter messages = new StringWriter();
    assertTrue(compiler.getTask(messages, null, null, List.of("-d", folder.toString(), "-proc:none", "-Xlint:all", "-Werror",
        "-cp", System.getProperty("java.class.path")), null, compiler.getStandardFileManager(null, null, null)
        .getJavaFileObjects(source)).call(), messages::toString);
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()}, getClass().getClassLoader())) {
      final var constructor = loader.loadClass("copied.CopiedTest").getDeclaredConstructor();
      constructor.setAccessible(true);
      return constructor.newInstance();
    }
  }

  /** Runs the copied methods, and none that a tool, such as one for coverage, has added to the class. */
  private static int run(final Object tests) throws ReflectiveOperationException {
    int count = 0;
    for (final Method method : tests.getClass().getDeclaredMethods()) {
      if (method.isSynthetic()) {
        continue;
      }
      assertTrue(method.isAnnotationPresent(Test.class));
      method.setAccessible(true);
      method.invoke(tests);
      count++;
    }
    return count;
  }

  @Test
  void theTestOfEveryShapeCompilesAndPasses() throws Exception {
    final SceneFile scene = SampleScenes.of(SampleScenes.perspective(), true, SampleScenes.everyShape());
    final Inspector inspector = new Inspector(scene, W, H);
    final Set<Object3D> seen = new HashSet<>();
    final Set<String> methods = new LinkedHashSet<>();
    for (int m = 0; m < W; m++) {
      for (int n = 0; n < H; n++) {
        final Inspection inspection = inspector.inspect(m, n);
        for (final Intersection intersection : inspection.intersections()) {
          if (seen.add(intersection.object())) {
            methods.add(JUnitTestWriter.of(inspection, intersection));
          }
        }
      }
    }
    assertEquals(SampleScenes.everyShape().length, methods.size());
    assertEquals(methods.size(), run(compiled(methods)));
  }

  /** Two triangles of a smooth mesh with a texture, flat ones with one, and smooth ones without. */
  private static List<TriangularMesh> shadedMeshes() {
    final Map<Integer, Point3D> vertices = Map.of(1, new Point3D(-1, -1, 0), 2, new Point3D(1, -1, 0.2f),
        3, new Point3D(1, 1, 0), 4, new Point3D(-1, 1, 0.1f));
    final Map<Integer, Vector3D> normals = Map.of(1, new Vector3D(-1, -1, 3), 2, new Vector3D(1, -1, 3));
    final Map<Integer, TexCoord2f> uv = Map.of(1, new TexCoord2f(0, 0), 2, new TexCoord2f(2, 0), 3, new TexCoord2f(2, 1.5f),
        4, new TexCoord2f(0, 1.5f));
    final Texture texture = new Texture(new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB));
    return List.of(
        new TriangularMesh(vertices, normals, uv, List.of("1/1/1 2/2/2 3/3", "1/1/1 3/3 4/4"), texture),
        new TriangularMesh(vertices, Map.of(), uv, List.of("1/1 2/2 3/3", "1/1 3/3 4/4"), texture),
        new TriangularMesh(vertices, normals, List.of("1//1 2//2 3", "1//1 3 4"), Color.PINK));
  }

  @Test
  void theTestOfAShadedTriangleRecreatesItsNormalsAndTextureCoordinates() throws Exception {
    for (final TriangularMesh mesh : shadedMeshes()) {
      final Object3D turned = new AffineTransformation(new Vector3f(1, 2, 1), new Vector3f(1, 1, 0), 30,
          new Vector3f(0.2f, 0, -1), mesh);
      for (final Object3D object : List.of(mesh, turned)) {
        final Inspector inspector = new Inspector(SampleScenes.of(SampleScenes.perspective(), true, object), W, H);
        final Set<String> methods = new LinkedHashSet<>();
        for (int m = 0; m < W; m += 5) {
          for (int n = 0; n < H; n += 7) {
            final Inspection inspection = inspector.inspect(m, n);
            inspection.winner().ifPresent(winner -> methods.add(JUnitTestWriter.of(inspection, winner)));
          }
        }
        assertTrue(methods.size() > 3, methods::toString);
        assertEquals(methods.size(), run(compiled(methods)));
      }
    }
  }

  @Test
  void theTestOfATexturedBallCompilesAndPasses() throws Exception {
    final Sphere ball = new Sphere(new Point3D(), 1, new Texture(new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB)));
    final Inspection inspection = new Inspector(SampleScenes.of(SampleScenes.perspective(), true, ball), W, H)
        .inspect(W / 2 - 3, H / 2 + 4);
    final String text = JUnitTestWriter.of(inspection, inspection.winner().orElseThrow());
    assertTrue(text.contains("hit.textureV()"), text);
    assertEquals(1, run(compiled(List.of(text))));
    final Object wrong = compiled(List.of(text.replace("hit.textureV()", "hit.textureV() + 0.01")));
    assertTrue(assertThrows(InvocationTargetException.class, () -> run(wrong)).getCause() instanceof AssertionFailedError);
  }

  @Test
  void theTestOfAHitFailsIfTheShapeIsAnother() throws Exception {
    final Sphere sphere = new Sphere(new Point3D(), 1, Color.RED);
    final Inspection inspection = new Inspector(SampleScenes.of(SampleScenes.perspective(), true, sphere), W, H)
        .inspect(W / 2, H / 2);
    final String text = JUnitTestWriter.of(inspection, inspection.intersections().get(0));
    assertEquals(1, run(compiled(List.of(text))));
    final String colour = ",\n        new java.awt.Color";
    final Object wrong = compiled(List.of(text.replace("1.0f" + colour, "1.1f" + colour)));
    final Exception thrown = assertThrows(InvocationTargetException.class, () -> run(wrong));
    assertTrue(thrown.getCause() instanceof AssertionFailedError);
  }

  private static final String LIT = """
      <image name="lit">
        <raster><W>40</W><H>30</H><backgroundColor>0.2 0.3 0.6</backgroundColor></raster>
        <rayTracer><wblock>32</wblock><hblock>32</hblock><showProgress>true</showProgress></rayTracer>
        <engine><illumination>true</illumination><recursionDepth>3</recursionDepth></engine>
        <camera><position>0 2 6</position><lookAt>0 0 0</lookAt><up>0 1 0</up></camera>
        <projection type="perspective"><fov>50</fov><aspect>1.33333</aspect></projection>
        <lights>
          <light type="omnidirectional"><position>3 5 4</position><spectrum>0.4 0.3 0.3</spectrum><power>90</power></light>
        </lights>
        <materials>
          <brdf id="matte" type="Phong-Lafortune"><diffuseReflectance>0.5 0.6 0.7</diffuseReflectance></brdf>
          <brdf id="mirror" type="Ideal-Conductor"><conductiveReflectance>0.9 0.8 0.7</conductiveReflectance></brdf>
        </materials>
        <models><model id="ball" type="sphere"><radius>1</radius></model></models>
        <scene>
          <object><modelId>ball</modelId><materialId>matte</materialId><translation>-1.1 0 0</translation></object>
          <object><modelId>ball</modelId><materialId>mirror</materialId><translation>1.1 0 0</translation></object>
        </scene>
      </image>
      """;

  @Test
  void theTestOfALitPixelCompilesAndPasses() throws Exception {
    final Path file = Files.writeString(folder.resolve("a \"lit\" scene.xml"), LIT);
    final SceneFile scene = SceneReader.read(file).scene().orElseThrow();
    final Inspector inspector = new Inspector(scene, 40, 30);
    final Set<String> methods = new LinkedHashSet<>();
    for (int m = 6; m < 34; m += 3) {
      final Inspection inspection = inspector.inspect(m, 14);
      if (inspection.light().isPresent()) {
        methods.add(LitPixelTestWriter.of(inspection, file));
      }
    }
    assertTrue(methods.size() > 5, methods::toString);
    assertEquals(methods.size(), run(compiled(methods)));
    final String bright = methods.stream().filter(text -> !text.contains("assertEquals(0.0,")).findFirst().orElseThrow();
    final Object wrong = compiled(List.of(bright.replaceAll("scene.lights\\(\\)", "new lights.LightGroup()")));
    final Exception thrown = assertThrows(InvocationTargetException.class, () -> run(wrong));
    assertTrue(thrown.getCause() instanceof AssertionFailedError);
    assertThrows(IllegalArgumentException.class, () -> LitPixelTestWriter.of(new Inspector(
        SampleScenes.of(SampleScenes.perspective(), true), W, H).inspect(0, 0), file));
  }

  /** A shape without constructor arguments. */
  private static final class Secret extends Object3D {

    Secret() {
      super(Color.RED);
    }

    @Override
    public Hit intersectionWith(final Ray ray) {
      return new Hit(1, ray.pointAtParameter(1), ray.getDirection(), this);
    }
  }

  @Test
  void theTestOfAShapeThatDoesNotTellItsArgumentsSaysWhatToWrite() throws Exception {
    final Inspection inspection = new Inspector(SampleScenes.of(SampleScenes.perspective(), true, new Secret()), W, H)
        .inspect(3, 4);
    final Object tests = compiled(List.of(JUnitTestWriter.of(inspection, inspection.intersections().get(0))));
    final Exception thrown = assertThrows(InvocationTargetException.class, () -> run(tests));
    assertEquals("make the Secret here, or write Secret.constructorArguments", thrown.getCause().getMessage());
  }
}
