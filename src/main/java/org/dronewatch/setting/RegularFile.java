package org.dronewatch.setting;

import java.nio.file.Files;
import java.nio.file.Path;

/** Tells files that end from what only has a name like one: reading a pipe or a device may wait or go on forever. */
public final class RegularFile {
    private RegularFile() {}

    /** What speaks against reading a file, as the end of a sentence; empty for a regular file. */
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
