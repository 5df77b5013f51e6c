package org.dronewatch.viewer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The scene files that the user has opened last, newest first, kept in a small file with a line for each. A file that
 * cannot be read or written is not an error: the list is then empty, or not kept.
 */
final class RecentScenes {
    /** Maximum number of entries. */
    static final int MOST = 10;

    private static final int LARGEST_FILE = 100_000;

    private final Path file;

    RecentScenes(Path file) {
        this.file = file;
    }

    /** The files, newest first; some may be gone by now. */
    synchronized List<Path> list() {
        List<Path> scenes = new ArrayList<>();
        try {
            if (Files.isRegularFile(file) && Files.size(file) <= LARGEST_FILE) {
                for (String line : Files.readAllLines(file)) {
                    if (!line.isBlank() && scenes.size() < MOST) {
                        scenes.add(Path.of(line));
                    }
                }
            }
        } catch (IOException | InvalidPathException e) {
            scenes.clear();
        }
        return scenes;
    }

    /** Moves a file to the front. */
    synchronized void add(Path scene) {
        Path whole = scene.toAbsolutePath().normalize();
        List<Path> scenes = list();
        scenes.remove(whole);
        scenes.add(0, whole);
        write(scenes.subList(0, Math.min(MOST, scenes.size())));
    }

    /** Forgets a file. */
    synchronized void remove(Path scene) {
        List<Path> scenes = list();
        if (scenes.remove(scene.toAbsolutePath().normalize())) {
            write(scenes);
        }
    }

    private void write(List<Path> scenes) {
        try {
            Path directory = file.toAbsolutePath().getParent();
            if (directory != null) {
                Files.createDirectories(directory);
            }
            Files.write(file, scenes.stream().map(Path::toString).toList());
        } catch (IOException e) {
            // The list is not kept; the menu then shows what was kept before.
            return;
        }
    }
}
