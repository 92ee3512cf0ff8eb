package inspection;

import java.util.List;
import java.util.Optional;

import models.SphereTrace;
import models.Object3D;
import tracer.Hit;

/**
 * The intersection of a ray with an object, which may be a miss if the object violated its contract.
 *
 * @param object the innermost object, without groups and transformations
 * @param sceneObject the object of the scene that contains it, or the object itself
 * @param name its name in the scene file; empty if it has none
 * @param hit the hit in scene coordinates; {@link Hit#NOHIT} for a miss
 * @param winner whether it is the closest hit, which is shown in the picture
 * @param localRays rays and hits in the frames of the transformations, from the outermost to the innermost
 * @param trace the sphere trace of a procedural object, in its own frame
 * @param violations the violations of the contract
 * @param failure the exception that it threw, with its source line; empty if none
 */
public record Intersection(Object3D object, Object3D sceneObject, String name, Hit hit, boolean winner,
    List<LocalRay> localRays, Optional<SphereTrace> trace, List<ContractViolation> violations, String failure) {

  /**
   * Copies the lists.
   *
   * @param object the innermost object, without groups and transformations
   * @param sceneObject the object of the scene that contains it, or the object itself
   * @param name its name in the scene file; empty if it has none
   * @param hit the hit in scene coordinates; {@link Hit#NOHIT} for a miss
   * @param winner whether it is the closest hit, which is shown in the picture
   * @param localRays rays and hits in the frames of the transformations, from the outermost to the innermost
   * @param trace the sphere trace of a procedural object, in its own frame
   * @param violations the violations of the contract
   * @param failure the exception that it threw, with its source line; empty if none
   */
  public Intersection {
    localRays = List.copyOf(localRays);
    violations = List.copyOf(violations);
  }

  Intersection asWinner() {
    return new Intersection(object, sceneObject, name, hit, true, localRays, trace, violations, failure);
  }
}
