package upnatray;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Objects;

import arguments.Messages;
import rendering.Progress;

/**
 * The progress of one picture: which parts of it are done. It is shown on a terminal; after an interruption
 * those parts are saved.
 */
final class PictureProgress implements Progress, Interruptible, AutoCloseable {

  private final Image image;
  private final Path target;
  private final InterruptHandler interruption;
  private final ProgressLine line;
  /** Column, row, width and height of each finished part. */
  private int[] done = new int[4096];
  private int end;

  private PictureProgress(final Image image, final Path scene, final Path target, final InterruptHandler interruption) {
    this.image = image;
    this.target = target;
    this.interruption = interruption;
    this.line = new ProgressLine(scene.toString(), (long) image.getWidth() * image.getHeight());
  }

  /** The picture of a scene is about to be rendered; an interruption stops that until the progress is closed. */
  static PictureProgress of(final Image image, final Path scene, final Path target, final InterruptHandler interruption) {
    final PictureProgress progress = new PictureProgress(image, scene, target, interruption);
    interruption.rendering(progress);
    return progress;
  }

  /** Saves the finished part of the picture under another name. */
  @Override
  public void interrupted() {
    final String file = Objects.toString(target.getFileName(), "");
    final String name = file.endsWith(".png") ? file.substring(0, file.length() - 4) : file;
    final Path partial = target.resolveSibling(name + ".partial.png");
    try {
      PngFile.save(partial(), partial);
      System.err.println(Messages.text("upnatray.partial", partial));
    } catch (final SaveException failure) {
      System.err.println(failure.getMessage());
    } catch (final OutOfMemoryError full) {
      System.err.println(Messages.text("upnatray.noPartial", partial));
    }
  }

  @Override
  public void close() {
    line.clear();
    interruption.rendered();
  }

  @Override
  public boolean tileDone(final int x, final int y, final int width, final int height) {
    synchronized (this) {
      if (end == done.length) {
        done = Arrays.copyOf(done, end + end / 8 * 4);
      }
      done[end++] = x;
      done[end++] = y;
      done[end++] = width;
      done[end++] = height;
    }
    line.add(width * height);
    return !interruption.requested();
  }

  /** The finished parts of the image, the rest transparent. */
  private synchronized BufferedImage partial() {
    final BufferedImage partial = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_INT_ARGB);
    int[] pixels = new int[0];
    for (int i = 0; i < end; i += 4) {
      pixels = pixels.length < done[i + 2] * done[i + 3] ? new int[done[i + 2] * done[i + 3]] : pixels;
      image.getRaster().getDataElements(done[i], done[i + 1], done[i + 2], done[i + 3], pixels);
      partial.getRaster().setDataElements(done[i], done[i + 1], done[i + 2], done[i + 3], pixels);
    }
    return partial;
  }
}
