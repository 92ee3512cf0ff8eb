package rendering;

import java.awt.Color;
import java.util.List;

import javax.vecmath.Vector3d;

import lights.Light;
import materials.Lambertian;
import materials.Material;
import materials.SpecularRays;
import materials.SurfaceInteraction;
import models.Object3D;
import primitives.Point3D;
import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;
import tracer.Hit;
import tracer.Ray;

/**
 * The rendering of a lit scene written down once more, without regard to speed: by recursion, with all objects asked for
 * every ray and every shadow. The oracle of {@link RecursiveTracerTest}.
 */
final class RecursiveTracer {

  private static final double LIFT = 1e-3;

  private final List<Object3D> objects;
  private final List<Light> lights;
  private final int recursionDepth;
  private final RadianceRGB background;

  RecursiveTracer(final List<Object3D> objects, final List<Light> lights, final int recursionDepth, final Color background,
      final double exposure) {
    this.objects = objects;
    this.lights = lights;
    this.recursionDepth = recursionDepth;
    final ReflectanceRGB linear = new ReflectanceRGB(background);
    this.background = new RadianceRGB(linear.getR(), linear.getG(), linear.getB()).times(1 / (10 * Math.pow(2, exposure)));
  }

  RadianceRGB radiance(final Ray ray) {
    return radiance(ray, 0, new ReflectanceRGB(1, 1, 1), 1);
  }

  /** Radiance of a ray, whose weight is a reflectance times a factor that may exceed 1. */
  private RadianceRGB radiance(final Ray ray, final int depth, final ReflectanceRGB weight, final double factor) {
    final double largest = factor * Math.max(weight.getR(), Math.max(weight.getG(), weight.getB()));
    if (depth > recursionDepth || largest < 1e-6) {
      return RadianceRGB.NORADIANCE;
    }
    final Hit hit = closest(ray);
    return hit.hits() ? new Surface(ray, hit).radiance(depth, weight, factor) : background;
  }

  private Hit closest(final Ray ray) {
    Hit closest = Hit.NOHIT;
    for (final Object3D object : objects) {
      final Hit hit = ask(object, ray);
      closest = hit.distance() < closest.distance() ? hit : closest;
    }
    return closest;
  }

  /** The first hit that counts: not that of the very surface that the ray leaves, if its hits are only floats. */
  private static Hit ask(final Object3D object, final Ray ray) {
    final Hit hit = object.intersectionWith(ray);
    return ray.isBlindTo(hit) ? object.intersectionWith(ray.from(ray.blindness())).seenFromBehind(ray.blindness()) : hit;
  }

  private static Vector3d unit(final Vector3d v) {
    final Vector3d unit = new Vector3d(v);
    unit.normalize();
    return unit;
  }

  private static Vector3d sum(final double a, final Vector3d v, final double b, final Vector3d w) {
    return new Vector3d(a * v.x + b * w.x, a * v.y + b * w.y, a * v.z + b * w.z);
  }

  /** A hit, seen by a ray: {@code g} and {@code n} are the normals on the viewer's side. */
  private final class Surface {

    private final Hit hit;
    private final Vector3d d;
    private final Vector3d wo;
    private final Vector3d g;
    private final Vector3d n;
    private final boolean outside;
    private final boolean bent;
    private final Material material;

    Surface(final Ray ray, final Hit hit) {
      this.hit = hit;
      d = new Vector3d(ray.directionX(), ray.directionY(), ray.directionZ());
      wo = sum(-1, d, 0, d);
      final Vector3d geometric = new Vector3d(hit.geometricX(), hit.geometricY(), hit.geometricZ());
      final Vector3d shading = new Vector3d(hit.normalX(), hit.normalY(), hit.normalZ());
      outside = geometric.dot(wo) >= 0;
      bent = !geometric.equals(shading);
      g = sum(outside ? 1 : -1, geometric, 0, geometric);
      n = lift(sum(outside ? 1 : -1, shading, 0, shading), wo);
      material = hit.getObject().getMaterial() != null ? hit.getObject().getMaterial()
          : new Lambertian(new ReflectanceRGB(hit.getObject().getColorAt(hit)));
    }

    /** unit(w + max(0, ε − w·a) a), where the normals differ. */
    private Vector3d lift(final Vector3d w, final Vector3d a) {
      return unit(bent ? sum(1, w, Math.max(0, LIFT - w.dot(a)), a) : w);
    }

    RadianceRGB radiance(final int depth, final ReflectanceRGB weight, final double factor) {
      RadianceRGB sum = RadianceRGB.NORADIANCE;
      for (final Light light : lights) {
        sum = sum.plus(direct(light));
      }
      final SpecularRays rays = new SpecularRays();
      if (material.specular(Math.min(1, n.dot(wo)), outside, rays)) {
        final Vector3d mirrored = lift(sum(1, d, 2 * n.dot(wo), n), g);
        sum = sum.plus(followed(outside, mirrored, depth, weight, factor,
            new double[] {rays.reflectedR(), rays.reflectedG(), rays.reflectedB()}));
        final double r = rays.ratio();
        final Vector3d bentRay = lift(sum(r, d, r * n.dot(wo) - rays.refractedCosine(), n), sum(-1, g, 0, g));
        sum = sum.plus(followed(!outside, bentRay, depth, weight, factor,
            new double[] {rays.refractedR(), rays.refractedG(), rays.refractedB()}));
      }
      return sum;
    }

    /** What an ideal ray brings, times its factors. */
    private RadianceRGB followed(final boolean outer, final Vector3d direction, final int depth, final ReflectanceRGB weight,
        final double factor, final double[] factors) {
      final double most = Math.max(1, Math.max(factors[0], Math.max(factors[1], factors[2])));
      final ReflectanceRGB next = new ReflectanceRGB((float) (weight.getR() * factors[0] / most),
          (float) (weight.getG() * factors[1] / most), (float) (weight.getB() * factors[2] / most));
      final RadianceRGB radiance = RecursiveTracer.this.radiance(hit.leave(outer, direction.x, direction.y, direction.z),
          depth + 1, next, factor * most);
      return new RadianceRGB(factors[0] * radiance.getR(), factors[1] * radiance.getG(), factors[2] * radiance.getB());
    }

    /** f(wi, wo) |n·wi| E V for one light. */
    private RadianceRGB direct(final Light light) {
      final Point3D P = hit.getPoint(), S = light.getPosition(P);
      final RadianceRGB E = light.getIrradianceAt(P);
      final Vector3d toLight = new Vector3d(S.x - hit.pointX(), S.y - hit.pointY(), S.z - hit.pointZ()), wi = unit(toLight);
      final double ci = n.dot(wi), facing = g.dot(wi);
      final boolean before = ci > 0 && facing > 0, behind = ci < 0 && facing < 0 && material.transmits();
      if (!(before || behind) || isBlocked(S, before)) {
        return RadianceRGB.NORADIANCE;
      }
      final SurfaceInteraction interaction = new SurfaceInteraction();
      interaction.setView(n.x, n.y, n.z, wo.x, wo.y, wo.z, outside);
      interaction.setIncident(wi.x, wi.y, wi.z);
      interaction.setIrradiance(Math.abs(ci) * E.getR(), Math.abs(ci) * E.getG(), Math.abs(ci) * E.getB());
      material.scatter(interaction);
      return new RadianceRGB(interaction.radianceR(), interaction.radianceG(), interaction.radianceB());
    }

    private boolean isBlocked(final Point3D S, final boolean before) {
      final double k = before ? hit.offset() : -hit.offset();
      final Vector3d start = sum(1, new Vector3d(hit.pointX(), hit.pointY(), hit.pointZ()), k, g);
      final Vector3d way = new Vector3d(S.x - start.x, S.y - start.y, S.z - start.z);
      final double distance = way.length();
      final Ray shadow = hit.leave(before == outside, way.x / distance, way.y / distance, way.z / distance);
      return objects.stream().anyMatch(object -> ask(object, shadow).distance() < distance * (1 - 1e-9));
    }
  }
}
