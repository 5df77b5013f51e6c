package org.dronewatch.app.option;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.dronewatch.setting.InputException;

/** A command-line argument that names a file or directory. */
public final class PathWord {
    private PathWord() {}

    /**
     * The path that an argument names.
     *
     * @param option option to which the argument belongs, such as {@code --out}, for messages; may be empty
     * @param word the argument
     * @throws InputException if the argument is empty, or not a valid path on this system
     */
    public static Path of(String option, String word) {
        if (word.isEmpty()) {
            // Java takes an empty path for the current directory; a shell variable was probably not set.
            throw new InputException((option + " ''").strip() + ": the path is empty");
        }
        try {
            return Path.of(word);
        } catch (InvalidPathException e) {
            throw new InputException(GivenOption.words(option, word) + ": not a path: " + e.getReason(), e);
        }
    }
}
