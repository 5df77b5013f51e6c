package org.dronewatch.report.provenance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronewatch.report.file.ShellWord;
import org.dronewatch.setting.InputException;

/**
 * The directories in which a command can write its results and scenes: a scene may name only files in its own directory
 * or below it, and nothing but earlier results of the command may be replaced.
 *
 * @param scene directory of the command's own scene
 * @param kind kind of the results
 * @param names pattern of the names of files that such results have besides the file that marks them
 * @param inputs input files of the command, which must not be replaced
 */
public record SceneDirectories(Path scene, ResultKind kind, Pattern names, CommandInputs inputs) {
    /**
     * What to do if a scene cannot be written to the intended directory, as the end of a sentence.
     *
     * @param writes creates the text of the scene for a directory, or throws an {@link InputException} if the scene
     *     cannot be written there
     */
    public String advice(Consumer<Path> writes) {
        return nearest(directory -> isPossible(() -> writes.accept(directory)))
                .map(directory -> "use --out " + ShellWord.of(directory))
                .orElse("put the scene and all files that it names into a separate directory, and use that for --out");
    }

    private static boolean isPossible(Runnable writing) {
        try {
            writing.run();
            return true;
        } catch (InputException e) {
            return false;
        }
    }

    /**
     * The nearest of them, from that of the command's own scene upwards; empty if there is none.
     *
     * @param takes whether the scene can be written into a directory
     */
    Optional<Path> nearest(Predicate<Path> takes) {
        // The root of a file system holds no results.
        return Stream.iterate(scene.toAbsolutePath().normalize(), Objects::nonNull, Path::getParent)
                .filter(directory -> directory.getNameCount() > 0)
                .filter(Files::isWritable)
                .filter(kind::isAlone)
                .filter(directory -> inputs.replacedIn(directory, names).isEmpty())
                .filter(this::isFree)
                .filter(takes)
                .findFirst();
    }

    /** Whether files with these names can only be earlier results of the command. */
    private boolean isFree(Path directory) {
        if (Files.isRegularFile(directory.resolve(kind.sign()))) {
            return true;
        }
        try (Stream<Path> files = Files.list(directory)) {
            return files.map(file -> String.valueOf(file.getFileName()))
                    .noneMatch(name -> names.matcher(name).matches());
        } catch (IOException e) {
            // What cannot be listed may hold anything.
            return false;
        }
    }
}
