package org.dronewatch.setting.file;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.dronewatch.setting.RegularFile;

/** Names of files that stand in a settings file: they start from its directory and may not lead out of it. */
final class FileNames {
    private final Path directory;

    FileNames(Path directory) {
        this.directory = directory.normalize();
    }

    /** The error in a name; empty if it is valid. */
    String wrongWith(String name) {
        Path file;
        try {
            file = directory.resolve(name).normalize();
        } catch (InvalidPathException e) {
            return "is not a path: " + e.getReason();
        }
        if (Path.of(name).isAbsolute() || !file.startsWith(directory)) {
            return "leads out of the directory of this file, " + directory + ": keep such files beside or below it";
        }
        return Files.exists(file) ? RegularFile.obstacle(file) : "does not exist in " + file.getParent();
    }
}
