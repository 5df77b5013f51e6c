package org.dronewatch.setting.file;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.RegularFile;

/** File names in a settings file: they are relative to its directory and must not lead out of it. */
final class FileNames {
    private final Path directory;

    FileNames(Path directory) {
        this.directory = directory.normalize();
    }

    /**
     * Whether a value names only files that exist where a settings file may name them: a single file, each of a list,
     * or one that may be left out. Adds a problem for each that is not there.
     *
     * @param field path of the setting
     */
    boolean areThere(FileName rule, Node node, Object value, String field, Problems problems) {
        if (value instanceof Optional<?> optional) {
            return optional.isEmpty() || areThere(rule, node, optional.get(), field, problems);
        }
        if (value instanceof List<?> list) {
            boolean all = true;
            for (int i = 0; i < list.size(); i++) {
                Node item =
                        node instanceof Node.Sequence written ? written.items().get(i) : node;
                all &= areThere(rule, item, list.get(i), field + "." + i, problems);
            }
            return all;
        }
        if (!rule.unless().isEmpty() && value.toString().startsWith(rule.unless())) {
            return true;
        }
        String wrong = wrongWith(value.toString());
        if (!wrong.isEmpty()) {
            problems.add(node.mark(), field, "file '" + value + "' " + wrong);
        }
        return wrong.isEmpty();
    }

    /** The error in a name; empty if it is valid. */
    private String wrongWith(String name) {
        Path file;
        try {
            file = directory.resolve(name).normalize();
        } catch (InvalidPathException e) {
            return "is not a path: " + e.getReason();
        }
        if (Path.of(name).isAbsolute() || !file.startsWith(directory)) {
            return "must be a relative path to a file in the directory of this file, " + directory + ", or below it";
        }
        return Files.exists(file) ? RegularFile.obstacle(file) : "does not exist in " + file.getParent();
    }
}
