package upnatray;

import java.awt.image.DataBufferInt;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;

import rendering.RenderSettings;

/**
 * Measures how fast a work is rendered: {@code bench/render-work FILE THREADS SECONDS OUT.png}, where FILE is a
 * {@code .work} file or a scene file. It renders frames for about the given time and prints the line
 * {@code RESULT mrays X percpu X build X load X hits X}: millions of pixels per second by the clock and per CPU second of
 * the rendering threads, from the second half of the frames, when the code is compiled; the seconds that building and
 * loading took; and the share of pixels that are not background. With 0 seconds it renders one frame.
 */
public final class RenderWork {

  /** Fewest frames, unless they take too long: the first ones run before the code is compiled. */
  private static final int FEWEST = 6;

  private final Work work;
  private final int threads;
  private final AtomicLong cpu = new AtomicLong();

  private RenderWork(final Work work, final int threads) {
    this.work = work;
    this.threads = threads;
  }

  /**
   * Measures one work.
   *
   * @param args the work's file, the number of threads, the seconds to go on for, and the PNG file to write
   */
  public static void main(final String[] args) {
    System.exit(run(args));
  }

  private static int run(final String[] args) {
    final int threads;
    final double seconds;
    final Path out;
    try {
      threads = Integer.parseInt(args[1]);
      seconds = Double.parseDouble(args[2]);
      out = Path.of(args[3]);
    } catch (ArrayIndexOutOfBoundsException | NumberFormatException wrongUsage) {
      System.err.println("Usage: bench/render-work FILE THREADS SECONDS OUT.png");
      return 2;
    }
    try {
      final long begin = System.nanoTime();
      final Work work = Work.read(Path.of(args[0]));
      new RenderWork(work, threads).run(seconds, (System.nanoTime() - begin) * 1e-9, out);
      return 0;
    } catch (IOException failure) {
      System.err.println(failure.getMessage());
      return 1;
    }
  }

  private void run(final double seconds, final double load, final Path out) throws IOException {
    final long begin = System.nanoTime();
    work.build();
    final double build = (System.nanoTime() - begin) * 1e-9;
    final Image image = new Image(work.width(), work.height(), work.background());
    final double[] clock = new double[1 << 16], busy = new double[1 << 16];
    int frames = 0;
    final long start = System.nanoTime();
    do {
      final long frame = System.nanoTime();
      cpu.set(seconds > 0 ? -threadTime() : 0);
      work.render(image, RenderSettings.STANDARD.withThreads(threads), seconds > 0 ? this::timed : Thread::new);
      clock[frames] = (System.nanoTime() - frame) * 1e-9;
      busy[frames++] = seconds > 0 ? (cpu.get() + threadTime()) * 1e-9 : threads * clock[0];
    } while (goesOn(frames, (System.nanoTime() - start) * 1e-9, seconds));
    report(Arrays.copyOfRange(clock, frames / 2, frames), Arrays.copyOfRange(busy, frames / 2, frames), load, build,
        share(image));
    try (OutputStream stream = Files.newOutputStream(out)) {
      PngEncoder.write(image, null, stream);
    }
  }

  private static boolean goesOn(final int frames, final double elapsed, final double seconds) {
    return seconds > 0 && frames < 1 << 16 && (elapsed < seconds || frames < FEWEST && elapsed < 4 * seconds);
  }

  /** A thread that adds its CPU time to the sum. */
  private Thread timed(final Runnable job) {
    return new Thread(() -> {
      job.run();
      cpu.addAndGet(threadTime());
    });
  }

  private static long threadTime() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  private void report(final double[] clock, final double[] busy, final double load, final double build, final double hits) {
    final double rays = work.width() * 1e-6 * work.height();
    Arrays.sort(clock);
    double sum = 0;
    for (final double frame : busy) {
      sum += frame;
    }
    System.out.println("RESULT mrays " + rounded(rays / clock[clock.length / 2])
        + " percpu " + rounded(rays * busy.length / sum) + " build " + rounded(build) + " load " + rounded(load)
        + " hits " + rounded(hits));
  }

  /** A number of four decimals; a Formatter would take longer to load than a small picture to render. */
  private static double rounded(final double number) {
    return Math.rint(number * 1e4) / 1e4;
  }

  /** Share of the pixels that do not have the colour of the background. */
  private double share(final Image image) {
    final int[] pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
    int hits = 0;
    for (final int argb : pixels) {
      hits += argb == work.background().getRGB() ? 0 : 1;
    }
    return (double) hits / pixels.length;
  }
}
