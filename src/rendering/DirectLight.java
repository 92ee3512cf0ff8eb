package rendering;

import java.util.Arrays;

import lights.Light;
import lights.TileIncidence;
import materials.Material;
import materials.SurfaceInteraction;
import models.Group3D;
import models.ShadowTile;

/**
 * The contribution of the lights to the surfaces that a tile of pixels sees, light by light for all of them together:
 * directions, irradiances and shadow rays in loops over arrays, which the compiler turns into vector instructions, then
 * what each material reflects, then the shadows of all that reflect anything. The operations and their order are those of
 * {@link WhittedTracer}, so that a pixel gets the same bits. One for each thread.
 */
final class DirectLight {

  private static final int MOST = TileSurfaces.MOST;

  private final Group3D scene;
  private final Light[] lights;
  private final TileSurfaces surfaces;
  private final TileIncidence incidence = new TileIncidence(MOST);
  private final SurfaceInteraction interaction = new SurfaceInteraction();
  private final ShadowTile shadows = new ShadowTile();

  /** Cosines of the light's directions to the normals that shade, and to the geometric ones. */
  private final double[] cosine = new double[MOST];
  private final double[] facing = new double[MOST];
  /** How far along the geometric normal the shadow rays start, their starts, directions and lengths. */
  private final double[] side = new double[MOST];
  private final double[] startX = new double[MOST];
  private final double[] startY = new double[MOST];
  private final double[] startZ = new double[MOST];
  private final double[] towardsX = new double[MOST];
  private final double[] towardsY = new double[MOST];
  private final double[] towardsZ = new double[MOST];
  private final double[] length = new double[MOST];
  /** The surfaces that cast a shadow ray. */
  private final int[] casting = new int[MOST];
  private int cast;
  /** The contribution of a light if nothing blocks it. */
  private final double[] lightR = new double[MOST];
  private final double[] lightG = new double[MOST];
  private final double[] lightB = new double[MOST];
  /** The contribution of all lights. */
  private final double[] r = new double[MOST];
  private final double[] g = new double[MOST];
  private final double[] b = new double[MOST];
  private final long[] lit = new long[MOST];
  private final long[] shadowed = new long[MOST];

  /** The light that arrives at some surfaces, whose materials scatter. */
  DirectLight(final Illumination illumination, final TileSurfaces surfaces) {
    this.scene = illumination.scene();
    this.lights = illumination.lights().toArray(new Light[0]);
    this.surfaces = surfaces;
  }

  /** Computes the contribution of the lights to the current surfaces. */
  void find() {
    final int n = surfaces.count();
    Arrays.fill(r, 0, n, 0);
    Arrays.fill(g, 0, n, 0);
    Arrays.fill(b, 0, n, 0);
    Arrays.fill(lit, 0, n, 0);
    Arrays.fill(shadowed, 0, n, 0);
    if (n > 0) {
      for (int number = 0; number < lights.length; number++) {
        lights[number].illuminate(n, surfaces.x, surfaces.y, surfaces.z, incidence);
        findCosines(n);
        makeShadowRays(n);
        add(n, number < Long.SIZE ? 1L << number : 0);
      }
    }
  }

  private void findCosines(final int n) {
    final TileSurfaces s = surfaces;
    for (int i = 0; i < n; i++) {
      final double x = incidence.directionX(i), y = incidence.directionY(i), z = incidence.directionZ(i);
      cosine[i] = s.normalX[i] * x + s.normalY[i] * y + s.normalZ[i] * z;
      facing[i] = s.geometricX[i] * x + s.geometricY[i] * y + s.geometricZ[i] * z;
    }
    for (int i = 0; i < n; i++) {
      side[i] = facing[i] > 0 ? s.offset[i] : -s.offset[i];
    }
  }

  /** See {@link ViewedSurface#towards}. */
  private void makeShadowRays(final int n) {
    final TileSurfaces s = surfaces;
    for (int i = 0; i < n; i++) {
      final double k = side[i], d = incidence.distance(i);
      final double x = d * incidence.directionX(i) - k * s.geometricX[i];
      final double y = d * incidence.directionY(i) - k * s.geometricY[i];
      final double z = d * incidence.directionZ(i) - k * s.geometricZ[i], l = Math.sqrt(x * x + y * y + z * z);
      startX[i] = s.x[i] + k * s.geometricX[i];
      startY[i] = s.y[i] + k * s.geometricY[i];
      startZ[i] = s.z[i] + k * s.geometricZ[i];
      towardsX[i] = x / l;
      towardsY[i] = y / l;
      towardsZ[i] = z / l;
      length[i] = l;
    }
  }

  /** Adds the contribution of a light; the bit is its own among the first 64 lights, or 0. */
  private void add(final int n, final long bit) {
    shadows.clear();
    cast = 0;
    for (int i = 0; i < n; i++) {
      final Material material = surfaces.materials[i];
      if (incidence.isLit(i)
          && (cosine[i] > 0 && facing[i] > 0 || cosine[i] < 0 && facing[i] < 0 && material.transmits())) {
        scatter(i, material);
      }
    }
    shadows.findBlocked(scene);
    for (int k = 0; k < cast; k++) {
      final int i = casting[k];
      if (shadows.isBlocked(k)) {
        shadowed[i] |= bit;
      } else {
        lit[i] |= bit;
        r[i] += lightR[i];
        g[i] += lightG[i];
        b[i] += lightB[i];
      }
    }
  }

  /** Computes the radiance that a surface sends along its ray, and casts its shadow ray unless that is zero. */
  private void scatter(final int i, final Material material) {
    final TileSurfaces s = surfaces;
    interaction.setView(s.normalX[i], s.normalY[i], s.normalZ[i], s.viewX[i], s.viewY[i], s.viewZ[i], s.outside[i]);
    interaction.setIncident(incidence.directionX(i), incidence.directionY(i), incidence.directionZ(i));
    final double k = Math.abs(cosine[i]);
    interaction.setIrradiance(k * incidence.irradianceR(i), k * incidence.irradianceG(i), k * incidence.irradianceB(i));
    material.scatter(interaction);
    TracerCalls.check(interaction);
    lightR[i] = interaction.radianceR();
    lightG[i] = interaction.radianceG();
    lightB[i] = interaction.radianceB();
    if (lightR[i] > 0 || lightG[i] > 0 || lightB[i] > 0) {
      castShadow(i);
    }
  }

  private void castShadow(final int i) {
    casting[cast++] = i;
    final double tmax = length[i] * WhittedTracer.BEFORE_LIGHT;
    if (surfaces.isExact(i)) {
      shadows.put(startX[i], startY[i], startZ[i], towardsX[i], towardsY[i], towardsZ[i], length[i], tmax);
    } else {
      shadows.put(surfaces.hits[i].leave(facing[i] > 0 == surfaces.outside[i], towardsX[i], towardsY[i],
          towardsZ[i]), length[i], tmax);
    }
  }

  /** Red radiance from all lights. */
  double r(final int i) {
    return r[i];
  }

  double g(final int i) {
    return g[i];
  }

  double b(final int i) {
    return b[i];
  }

  /** The first 64 lights that contribute to a surface: bit i for light i. */
  long lit(final int i) {
    return lit[i];
  }

  /** The first 64 lights that would contribute to a surface, but are blocked. */
  long shadowed(final int i) {
    return shadowed[i];
  }
}
