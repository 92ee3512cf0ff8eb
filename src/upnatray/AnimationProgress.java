package upnatray;

import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;

import arguments.Messages;
import rendering.Progress;

/** The progress of an animation, all its pictures together. It is shown on a terminal, and an interruption ends it. */
final class AnimationProgress implements Progress, Interruptible, AutoCloseable {

  private final InterruptHandler interruption;
  private final ProgressLine line;
  private final int pictures;
  private final AtomicInteger complete;

  /**
   * The progress of an animation that is about to be rendered.
   *
   * @param scene the scene
   * @param complete number of its pictures that are there already
   * @param pictures number of all its pictures
   * @param pixels number of pixels of all pictures that are to be rendered
   * @param interruption is to stop the rendering until the progress is closed
   */
  AnimationProgress(final Path scene, final int complete, final int pictures, final long pixels,
      final InterruptHandler interruption) {
    this.complete = new AtomicInteger(complete);
    this.pictures = pictures;
    this.interruption = interruption;
    this.line = new ProgressLine(scene.toString(), pixels);
    interruption.rendering(this);
  }

  /** One more picture is saved. */
  void pictureDone() {
    complete.incrementAndGet();
  }

  @Override
  public boolean tileDone(final int x, final int y, final int width, final int height) {
    line.add(width * height);
    return !interruption.requested();
  }

  @Override
  public void interrupted() {
    System.err.println(Messages.text("upnatray.animationInterrupted", complete.get(), pictures));
  }

  @Override
  public void close() {
    line.clear();
    interruption.rendered();
  }
}
