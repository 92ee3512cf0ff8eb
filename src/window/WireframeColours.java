package window;

import java.awt.Color;
import java.util.Map;

import inspection.Wireframe;

/** The colours of lines that do not have that of an object. */
final class WireframeColours {

  private static final Map<Wireframe.Kind, Color> COLOURS = Map.ofEntries(
      Map.entry(Wireframe.Kind.AXIS_X, new Color(0xd03030)), Map.entry(Wireframe.Kind.AXIS_Y, new Color(0x2f9e44)),
      Map.entry(Wireframe.Kind.AXIS_Z, new Color(0x3060d0)), Map.entry(Wireframe.Kind.WINDOW, new Color(0xe08a00)),
      Map.entry(Wireframe.Kind.GRID, new Color(0xd9b477)), Map.entry(Wireframe.Kind.FRUSTUM, new Color(0xb0b0b0)),
      Map.entry(Wireframe.Kind.RAY, new Color(0xd000b0)), Map.entry(Wireframe.Kind.NORMAL, new Color(0x00a0b0)),
      Map.entry(Wireframe.Kind.SHADOW_LIT, new Color(0xf0a000)),
      Map.entry(Wireframe.Kind.SHADOW_BLOCKED, new Color(0x606060)),
      Map.entry(Wireframe.Kind.REFLECTED, new Color(0x2f7fd6)), Map.entry(Wireframe.Kind.REFRACTED, new Color(0x18a078)),
      Map.entry(Wireframe.Kind.SELECTED, new Color(0xff2020)));

  private WireframeColours() {
  }

  /** Whether lines of a kind have a colour of their own. */
  static boolean has(final Wireframe.Kind kind) {
    return COLOURS.containsKey(kind);
  }

  static Color of(final Wireframe.Kind kind) {
    return COLOURS.getOrDefault(kind, Color.GRAY);
  }
}
