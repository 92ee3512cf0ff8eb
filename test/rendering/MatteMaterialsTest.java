package rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.awt.Color;

import org.junit.jupiter.api.Test;

import materials.Lambertian;
import models.RandomNumbers;
import radiometry.ReflectanceRGB;

/** Matte materials of more colours than are kept. */
class MatteMaterialsTest {

  @Test
  void everyColourHasItsOwnMaterialHoweverManyThereAre() {
    final RandomNumbers numbers = new RandomNumbers("matte colours");
    final MatteMaterials matte = new MatteMaterials();
    for (int i = 0; i < 20_000; i++) {
      final Color color = new Color(numbers.index(1 << 12) * 0x1003 & 0xffffff);
      assertEquals(new Lambertian(new ReflectanceRGB(color)).toString(), matte.of(color).toString(), () -> color.toString());
      assertSame(matte.of(color), matte.of(color), "asked for again, it is the same object");
    }
  }

  @Test
  void blackIsAColourToo() {
    final MatteMaterials matte = new MatteMaterials();
    for (final Color color : new Color[] {new Color(0, 0, 0, 0), Color.BLACK, Color.WHITE}) {
      assertEquals(new Lambertian(new ReflectanceRGB(color)).toString(), matte.of(color).toString());
    }
  }
}
