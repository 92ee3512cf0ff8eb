package rendering;

import static arguments.Arguments.notNull;

import java.awt.Color;
import java.util.List;
import java.util.stream.IntStream;

import radiometry.RadianceRGB;
import radiometry.ReflectanceRGB;
import tracer.Hit;
import tracer.Ray;

/**
 * Shows how much each light contributes: a colour for each light, scaled by the luminance that it contributes to the
 * pixel, added up. The background in mirrors and glass is not light of the scene and is left out.
 */
public final class LightColours implements Shading {

  /** Weights of red, green, and blue in the luminance of linear sRGB: IEC 61966-2-1, 1999. */
  private static final double[] LUMINANCE = {0.2126, 0.7152, 0.0722};

  private final Illumination illumination;
  private final List<ReflectanceRGB> colours;

  /**
   * The colours of the lights of an illumination.
   *
   * @param illumination the illumination
   * @throws IllegalArgumentException if it is null
   */
  public LightColours(final Illumination illumination) {
    this.illumination = notNull("illumination", illumination);
    this.colours = IntStream.range(0, illumination.lights().size()).mapToObj(LightColours::color).map(ReflectanceRGB::new)
        .toList();
  }

  /**
   * The colour of a light.
   *
   * @param number its number, from 0
   * @return its colour, which differs from those of the lights before and after it
   */
  public static Color color(final int number) {
    return ObjectColours.color(number);
  }

  @Override
  public int argb(final Ray ray, final Hit hit) {
    final double[] sum = new double[3];
    illumination.radiance(ray, hit, new LightObserver() {
      @Override
      public void light(final Contribution contribution) {
        if (contribution.outcome() == Outcome.LIT) {
          final RadianceRGB its = contribution.radiance();
          final double luminance = LUMINANCE[0] * its.getR() + LUMINANCE[1] * its.getG() + LUMINANCE[2] * its.getB();
          final ReflectanceRGB color = colours.get(contribution.number());
          sum[0] += luminance * color.getR();
          sum[1] += luminance * color.getG();
          sum[2] += luminance * color.getB();
        }
      }
    });
    return illumination.encoded(sum[0], sum[1], sum[2]);
  }
}
