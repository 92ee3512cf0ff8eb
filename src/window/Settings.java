package window;

import java.awt.Rectangle;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.BackingStoreException;
import java.util.prefs.Preferences;

/** What the window remembers from one run to the next, in the preferences of the user. */
final class Settings {

  private static final int MOST_RECENT = 8;

  /** Where nothing can be kept, the preferences would complain about it every half minute. */
  private static final Logger COMPLAINTS = Logger.getLogger("java.util.prefs");

  private final Preferences preferences;

  Settings(final Preferences preferences) {
    this.preferences = preferences;
  }

  static Settings ofUser() {
    COMPLAINTS.setLevel(Level.OFF);
    return new Settings(Preferences.userRoot().node("upnatray/window"));
  }

  boolean isDark() {
    return preferences.getBoolean("dark", false);
  }

  void setDark(final boolean dark) {
    preferences.putBoolean("dark", dark);
  }

  Rectangle bounds() {
    return new Rectangle(preferences.getInt("x", -1), preferences.getInt("y", -1),
        preferences.getInt("width", 1180), preferences.getInt("height", 760));
  }

  void setBounds(final Rectangle bounds) {
    preferences.putInt("x", bounds.x);
    preferences.putInt("y", bounds.y);
    preferences.putInt("width", bounds.width);
    preferences.putInt("height", bounds.height);
  }

  /** The folder where the last file was. */
  Path folder() {
    return Path.of(preferences.get("folder", ""));
  }

  void setFolder(final Path folder) {
    preferences.put("folder", folder.toString());
  }

  /** The scenes opened last, the latest first. */
  List<Path> recent() {
    final List<Path> recent = new ArrayList<>();
    for (int i = 0; i < MOST_RECENT; i++) {
      final String path = preferences.get("recent" + i, "");
      if (!path.isEmpty()) {
        recent.add(Path.of(path));
      }
    }
    return recent;
  }

  /** Puts a scene first. A path too long to be remembered is left out. */
  void addRecent(final Path scene) {
    final List<Path> recent = recent();
    final Path absolute = scene.toAbsolutePath().normalize();
    recent.remove(absolute);
    recent.add(0, absolute);
    recent.removeIf(path -> path.toString().length() > Preferences.MAX_VALUE_LENGTH);
    for (int i = 0; i < Math.min(MOST_RECENT, recent.size()); i++) {
      preferences.put("recent" + i, recent.get(i).toString());
    }
  }

  /** Writes what has changed; what cannot be written is forgotten, which does no harm. */
  void save() {
    try {
      preferences.flush();
    } catch (final BackingStoreException forgotten) {
      System.getLogger("upnatray").log(System.Logger.Level.DEBUG, forgotten);
    }
  }
}
