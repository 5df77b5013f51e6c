package org.dronewatch.viewer;

import java.awt.Rectangle;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Properties;

/**
 * How the user has arranged the window, kept in a small file until the window is next opened. A file that cannot be
 * read or written is not an error: the window then has its default layout.
 */
final class ViewerLayout {
    private static final int LARGEST_FILE = 10_000;

    private final Path file;
    private final Properties values = new Properties();

    /** Reads the file, if it is there. */
    ViewerLayout(Path file) {
        this.file = file;
        try {
            if (Files.isRegularFile(file) && Files.size(file) <= LARGEST_FILE) {
                try (InputStream stream = Files.newInputStream(file)) {
                    values.load(stream);
                }
            }
        } catch (IOException | IllegalArgumentException e) {
            values.clear();
        }
    }

    /** The file of this user. */
    static Path ofUser() {
        return Path.of(System.getProperty("user.home"), ".dronewatch", "viewer.properties");
    }

    Optional<Rectangle> bounds() {
        return number("x").flatMap(x -> number("y").flatMap(y -> number("width")
                .flatMap(width -> number("height").map(height -> new Rectangle(x, y, width, height)))));
    }

    void setBounds(Rectangle bounds) {
        set("x", bounds.x);
        set("y", bounds.y);
        set("width", bounds.width);
        set("height", bounds.height);
    }

    boolean isDark() {
        return "dark".equals(values.getProperty("theme"));
    }

    void setDark(boolean dark) {
        values.setProperty("theme", dark ? "dark" : "light");
    }

    /** Where a divider is, by its name, in pixels. */
    Optional<Integer> divider(String name) {
        return number("divider." + name);
    }

    void setDivider(String name, int location) {
        set("divider." + name, location);
    }

    private Optional<Integer> number(String key) {
        try {
            return Optional.ofNullable(values.getProperty(key)).map(Integer::valueOf);
        } catch (NumberFormatException e) {
            return Optional.empty();
        }
    }

    private void set(String key, int value) {
        values.setProperty(key, Integer.toString(value));
    }

    /** Writes the file; returns whether it succeeded. */
    boolean save() {
        try {
            Path directory = file.toAbsolutePath().getParent();
            if (directory != null) {
                Files.createDirectories(directory);
            }
            try (OutputStream stream = Files.newOutputStream(file)) {
                values.store(stream, "dronewatch viewer layout");
            }
            return true;
        } catch (IOException e) {
            return false;
        }
    }
}
