package org.dronewatch.setting;

import java.nio.file.Files;
import java.nio.file.Path;

/** Distinguishes regular files from pipes and devices, whose reading may block or never end. */
public final class RegularFile {
    private RegularFile() {}

    /** The reason why a file cannot be read, as the end of a sentence; empty for a regular file. */
    public static String obstacle(Path file) {
        if (Files.isRegularFile(file)) {
            return "";
        }
        if (!Files.exists(file)) {
            return "no such file";
        }
        return Files.isDirectory(file) ? "is a directory" : "is a pipe or a device, not a file";
    }
}
