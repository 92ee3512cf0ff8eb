package window;

import rendering.RenderPass;

/**
 * How a scene is to be rendered.
 *
 * @param pass what the picture is to show
 * @param size its size
 * @param samples how many rays a pixel gets in the end
 * @param threads number of threads, at least 1
 */
record PictureOptions(RenderPass pass, PictureSize size, Samples samples, int threads) {

  PictureOptions with(final RenderPass next) {
    return new PictureOptions(next, size, samples, threads);
  }

  PictureOptions with(final PictureSize next) {
    return new PictureOptions(pass, next, samples, threads);
  }

  PictureOptions with(final Samples next) {
    return new PictureOptions(pass, size, next, threads);
  }

  /** Whether the picture is refined by more rays once it has been rendered with one for each pixel. Numbers have no mean. */
  boolean isRefined() {
    return samples.K() > 1 && !pass.showsNumbers();
  }
}
