package scenes;

import java.awt.Color;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

import diagnostics.Problem;
import meshes.MaterialFiles;
import meshes.ObjMesh;
import meshes.ObjReader;
import meshes.TextureFile;
import models.Appearance;
import models.MeshData;
import models.TriangularMesh;
import primitives.Point3D;
import primitives.Vector3D;
import scenes.Mutations.Kind;
import tracer.Hit;
import tracer.Ray;
import tracer.RayGenerator;
import upnatray.RenderJob;

/**
 * Feeds the readers with damaged files: {@code Fuzz COUNT SEED FOLDER}, where an empty seed is the time. Whatever a file
 * contains, its reader must return within five seconds, with each problem at a place within the file; and rays must be
 * shaded in a scene that it accepts. A file that breaks this is kept in the folder, and the exit status is 1.
 */
final class Fuzz implements AutoCloseable {

  private static final int LONGEST_SECONDS = 5;
  private static final int LONGEST_MESSAGE = 1000;
  private static final int W = 3;
  private static final int H = 2;

  private final Path folder;
  private final Mutations mutations = new Mutations();
  private ExecutorService reader = newReader();

  Fuzz(final Path folder) throws IOException {
    this.folder = Files.createDirectories(folder);
    Files.writeString(folder.resolve(Mutations.MESH_FILE), Mutations.MESH);
    Files.write(folder.resolve(Mutations.IMAGE_FILE), Mutations.image("PNG", new Random(1)));
  }

  /** A separate thread for reading, so that a reader that does not end can be reported. */
  private static ExecutorService newReader() {
    return Executors.newSingleThreadExecutor(task -> {
      final Thread thread = new Thread(task, "reader");
      thread.setDaemon(true);
      return thread;
    });
  }

  public static void main(final String[] args) throws IOException, InterruptedException {
    final int count = Integer.parseInt(args[0]);
    final long seed = args[1].isEmpty() ? System.currentTimeMillis() : Long.parseLong(args[1]);
    int findings = 0;
    try (Fuzz fuzz = new Fuzz(Path.of(args[2]))) {
      for (final Kind kind : Kind.values()) {
        System.out.println(kind + ": " + count + " files, seed " + seed);
        for (int i = 0; i < count; i++) {
          findings += fuzz.isSound(kind, seed + i) ? 0 : 1;
        }
      }
    }
    System.out.println(findings + " findings");
    System.exit(findings == 0 ? 0 : 1);
  }

  private boolean isSound(final Kind kind, final long seed) throws IOException, InterruptedException {
    final String finding = finding(kind, seed);
    if (finding != null) {
      final Path kept = folder.resolve("found-" + kind + "-" + seed);
      Files.write(kept, mutations.file(kind, seed));
      System.out.println(kept + ": " + finding);
    }
    return finding == null;
  }

  /** The fault found with the file of a seed; null if none. */
  String finding(final Kind kind, final long seed) throws IOException, InterruptedException {
    final byte[] bytes = mutations.file(kind, seed);
    final Path file = Files.write(folder.resolve(kind.isScene() ? "fuzz.xml" : kind.isImage() ? "fuzz.image"
        : kind.isMaterial() ? Mutations.MATERIAL_FILE : "fuzz.obj"), bytes);
    try {
      return reader.submit(() -> kind.isScene() ? ofScene(file, bytes) : kind.isImage() ? ofImage(file)
          : kind.isMaterial() ? ofMaterials(file, bytes) : ofMesh(file, bytes)).get(LONGEST_SECONDS, TimeUnit.SECONDS);
    } catch (final ExecutionException failure) {
      final StackTraceElement[] where = failure.getCause().getStackTrace();
      return failure.getCause() + (where.length > 0 ? " at " + where[0] : "");
    } catch (final TimeoutException e) {
      reader.shutdown();
      reader = newReader();
      return "takes longer than " + LONGEST_SECONDS + " seconds";
    }
  }

  private static String ofScene(final Path file, final byte[] bytes) {
    final ReadResult reading = SceneReader.read(file);
    final String finding = ofProblems(reading.problems(), reading.scene().isPresent(), file, bytes);
    return finding != null || reading.scene().isEmpty() ? finding : ofRays(reading.scene().get());
  }

  private static String ofMesh(final Path file, final byte[] bytes) {
    final ObjReader.Result reading = new ObjReader(file, true).read();
    final String finding = ofProblems(reading.problems(), reading.mesh() != null, file, bytes);
    return finding != null || reading.mesh() == null ? finding : ofHits(reading.mesh().smooth());
  }

  /** What is wrong with hits of a mesh; that all its triangles vanish in floats is not. */
  private static String ofHits(final MeshData data) {
    final TriangularMesh mesh;
    try {
      mesh = TriangularMesh.of(data, Appearance.of(Color.RED));
    } catch (final IllegalArgumentException nothingLeft) {
      return null;
    }
    for (int i = 0; i < W * H; i++) {
      final Hit hit = mesh.intersectionWith(new Ray(new Point3D(0.4f * i, 0.3f, 5), new Vector3D(0, 0, -1)));
      if (hit.hits() && !Double.isFinite(hit.normalX() + hit.normalY() + hit.normalZ())) {
        return "ray " + i + ": " + hit;
      }
    }
    return null;
  }

  private static String ofMaterials(final Path file, final byte[] bytes) {
    final Path mesh = file.resolveSibling(Mutations.MESH_FILE);
    final ObjMesh read = new ObjReader(mesh, true).read().mesh();
    final MaterialFiles materials = new MaterialFiles(mesh, read);
    final TriangularMesh coloured = TriangularMesh.of(read.smooth(), materials.appearances(), materials.ofTriangles());
    final Hit hit = coloured.intersectionWith(new Ray(new Point3D(0.6f, 0.3f, 5), new Vector3D(0, 0, -1)));
    return hit.getObject().getColorAt(hit) == null ? "no colour" : ofProblems(materials.problems(), true, file, bytes);
  }

  private static String ofImage(final Path file) {
    try {
      return TextureFile.read(file).getMeanColor() == null ? "no colour" : null;
    } catch (final TextureFile.UnusableException unusable) {
      return unusable.getMessage().isBlank() || unusable.getMessage().lines().count() != 1 ? unusable.getMessage() : null;
    }
  }

  private static String ofRays(final SceneFile scene) {
    final RayGenerator rays = scene.camera().getRayGenerator(W, H);
    for (int i = 0; i < W * H; i++) {
      final Hit hit = scene.objects().intersectionWith(rays.getRay(i % W, i / W));
      if (hit.hits()) {
        RenderJob.shading(scene).argb(rays.getRay(i % W, i / W), hit);
      }
      if (hit.hits() && !(hit.getT() > 0 && Double.isFinite(hit.normalX() + hit.normalY() + hit.normalZ()))) {
        return "pixel " + i + ": " + hit;
      }
    }
    return null;
  }

  private static String ofProblems(final List<Problem> problems, final boolean sound, final Path file, final byte[] bytes) {
    if (sound == problems.stream().anyMatch(Problem::isError)) {
      return "sound: " + sound + ", but " + problems;
    }
    final String[] lines = startsAsZip(bytes) || isWide(file, bytes) ? null : lines(file, bytes);
    return problems.stream().map(problem -> ofProblem(problem, file, lines)).filter(Objects::nonNull)
        .findFirst().orElse(null);
  }

  private static String[] lines(final Path file, final byte[] bytes) {
    final String text = file.toString().endsWith(".xml") ? Decoding.of(bytes).text()
        : new String(bytes, StandardCharsets.ISO_8859_1);
    return text.split("\r\n|\r|\n", -1);
  }

  private static String ofProblem(final Problem problem, final Path file, final String[] lines) {
    final String message = problem.message();
    if (message.isBlank() || message.length() > LONGEST_MESSAGE || message.lines().count() != 1) {
      return "message: " + message;
    }
    return lines != null && problem.file().equals(file.toString()) && !isWithin(problem, lines) ? "place: " + problem : null;
  }

  private static boolean isWithin(final Problem problem, final String[] lines) {
    return problem.line() >= 1 && problem.line() <= lines.length && problem.column() >= 1
        && problem.column() <= lines[problem.line() - 1].length() + 1;
  }

  /** Whether a mesh or a material file is read in an encoding of more than one byte to each letter. */
  private static boolean isWide(final Path file, final byte[] bytes) {
    return !file.toString().endsWith(".xml") && bytes.length > 1
        && (bytes[0] == 0 || bytes[1] == 0 || (bytes[0] & bytes[1] & 0xfe) == 0xfe);
  }

  private static boolean startsAsZip(final byte[] bytes) {
    return bytes.length > 3 && bytes[0] == 'P' && bytes[1] == 'K';
  }

  @Override
  public void close() {
    reader.shutdown();
  }
}
