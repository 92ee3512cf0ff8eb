package scenes;

import java.util.List;
import java.util.Optional;

import diagnostics.Problem;

/**
 * The result of reading a scene file.
 *
 * @param scene the scene; empty if there is an error
 * @param problems errors and warnings, in the order of the file; those of a mesh are at the place where the scene names
 *     it
 */
public record ReadResult(Optional<SceneFile> scene, List<Problem> problems) {

  /**
   * Copies the list.
   *
   * @param scene the scene; empty if there is an error
   * @param problems errors and warnings
   */
  public ReadResult {
    problems = List.copyOf(problems);
  }
}
