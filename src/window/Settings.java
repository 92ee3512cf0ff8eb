package window;

import java.awt.Rectangle;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.BackingStoreException;
import java.util.prefs.Preferences;

/** The settings of the window, kept in the user's preferences. */
final class Settings {

  private static final int MAX_RECENT = 8;

  /** Where preferences cannot be stored, their logger would warn every 30 seconds. */
  private static final Logger PREFERENCES_LOGGER = Logger.getLogger("java.util.prefs");

  private final Preferences preferences;

  Settings(final Preferences preferences) {
    this.preferences = preferences;
  }

  static Settings ofUser() {
    PREFERENCES_LOGGER.setLevel(Level.OFF);
    return new Settings(Preferences.userRoot().node("upnatray/window"));
  }

  boolean isDark() {
    return preferences.getBoolean("dark", false);
  }

  void setDark(final boolean dark) {
    preferences.putBoolean("dark", dark);
  }

  /** The bounds of the last window, or the default ones. */
  Rectangle bounds() {
    return new Rectangle(preferences.getInt("x", 0), preferences.getInt("y", 0), preferences.getInt("width", 1180),
        preferences.getInt("height", 760));
  }

  /** Whether the bounds are those of an earlier window, and so say where it was. */
  boolean hasBounds() {
    return preferences.getInt("width", 0) > 0;
  }

  boolean isMaximized() {
    return preferences.getBoolean("maximized", false);
  }

  void setMaximized(final boolean maximized) {
    preferences.putBoolean("maximized", maximized);
  }

  void setBounds(final Rectangle bounds) {
    preferences.putInt("x", bounds.x);
    preferences.putInt("y", bounds.y);
    preferences.putInt("width", bounds.width);
    preferences.putInt("height", bounds.height);
  }

  /** The folder of the file used last. */
  Path folder() {
    return path(preferences.get("folder", "")).orElse(Path.of(""));
  }

  /** A stored path; empty if it is invalid here, as it was stored in another locale or by another system. */
  private static Optional<Path> path(final String text) {
    try {
      return Optional.of(Path.of(text));
    } catch (final InvalidPathException foreign) {
      return Optional.empty();
    }
  }

  void setFolder(final Path folder) {
    preferences.put("folder", folder.toString());
  }

  /** The recently opened scenes, the latest first. */
  List<Path> recent() {
    final List<Path> recent = new ArrayList<>();
    for (int i = 0; i < MAX_RECENT; i++) {
      final String path = preferences.get("recent" + i, "");
      if (!path.isEmpty()) {
        path(path).ifPresent(recent::add);
      }
    }
    return recent;
  }

  /** Adds a scene as the latest. A path too long for the preferences is omitted. */
  void addRecent(final Path scene) {
    final List<Path> recent = recent();
    final Path absolute = scene.toAbsolutePath().normalize();
    recent.remove(absolute);
    recent.add(0, absolute);
    recent.removeIf(path -> path.toString().length() > Preferences.MAX_VALUE_LENGTH);
    for (int i = 0; i < Math.min(MAX_RECENT, recent.size()); i++) {
      preferences.put("recent" + i, recent.get(i).toString());
    }
  }

  /** Stores the settings. Failure is harmless: the next run uses the previous ones. */
  void save() {
    try {
      preferences.flush();
    } catch (final BackingStoreException | IllegalStateException failure) {
      System.getLogger("upnatray").log(System.Logger.Level.DEBUG, failure);
    }
  }
}
