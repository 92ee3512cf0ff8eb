package inspection;

import java.util.List;
import java.util.Optional;

import models.SphereTrace;
import models.Object3D;
import tracer.Hit;

/**
 * An object that a ray meets, or that answered it wrongly.
 *
 * @param object the object that was met, inside of all groups and transformations
 * @param whole the object of the scene that it is part of; the same if it is not part of another
 * @param name what the scene calls it; empty if it has no name
 * @param hit the hit, in the scene; {@link Hit#NOHIT} if there are only findings to tell
 * @param winner whether it is what the scene answers, the one that is painted
 * @param frames for an object that is transformed its ray and hit in its own frame, from the outermost transformation to the
 *     innermost
 * @param march for an object that is marched to, the march in its own frame
 * @param findings what is wrong with the answer
 * @param failure the exception, if it threw one, with its place
 */
public record Intersection(Object3D object, Object3D whole, String name, Hit hit, boolean winner, List<LocalRay> frames,
    Optional<SphereTrace> march, List<ContractViolation> findings, String failure) {

  /**
   * Copies the lists.
   *
   * @param object the object that was met, inside of all groups and transformations
   * @param whole the object of the scene that it is part of; the same if it is not part of another
   * @param name what the scene calls it; empty if it has no name
   * @param hit the hit, in the scene; {@link Hit#NOHIT} if there are only findings to tell
   * @param winner whether it is what the scene answers, the one that is painted
   * @param frames for an object that is transformed its ray and hit in its own frame, from the outermost
   *     transformation to the innermost
   * @param march for an object that is marched to, the march in its own frame
   * @param findings what is wrong with the answer
   * @param failure the exception, if it threw one, with its place
   */
  public Intersection {
    frames = List.copyOf(frames);
    findings = List.copyOf(findings);
  }

  Intersection asWinner() {
    return new Intersection(object, whole, name, hit, true, frames, march, findings, failure);
  }
}
