package org.dronewatch.report.provenance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.dronewatch.scene.Scene;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * The files that describe what a command does; its results must not replace them.
 *
 * @param files their paths
 */
public record CommandInputs(List<Path> files) {
    /** Copies the list. */
    public CommandInputs {
        files = List.copyOf(files);
    }

    /** The file of a scene; none for a scene that was not read from a file. */
    public static CommandInputs of(Scene scene) {
        return new CommandInputs(scene.files().stream()
                .limit(1)
                .map(file -> scene.directory().resolve(file.file()))
                .toList());
    }

    /**
     * Checks that no input is in the output directory under the name of a result.
     *
     * @param names matches the names of results
     * @throws InputException with a one-line message, if there is such an input
     */
    public void checkKept(Path target, Pattern names) {
        replacedIn(target, names).ifPresent(input -> {
            throw new InputException("output directory " + PlainText.value(target) + " holds an input of the command ("
                    + PlainText.value(input.getFileName()) + "), which would be replaced: choose another directory");
        });
    }

    /** The first input that is in a directory under the name of a result. */
    Optional<Path> replacedIn(Path directory, Pattern names) {
        return files.stream()
                .map(Path::toAbsolutePath)
                .filter(input ->
                        names.matcher(String.valueOf(input.getFileName())).matches())
                .filter(input -> isSame(input.getParent(), directory))
                .findFirst();
    }

    private static boolean isSame(Path one, Path other) {
        try {
            return Files.exists(other) && Files.isSameFile(one, other);
        } catch (IOException e) {
            // An input that is gone cannot be replaced.
            return false;
        }
    }
}
