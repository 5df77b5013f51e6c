package org.dronewatch.report;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.dronewatch.setting.InputException;

/**
 * A directory of results that appears whole: files are written into a directory beside it and moved into place at the
 * end. Whatever else the target holds stays as it is.
 */
final class OutputDirectory implements AutoCloseable {
    private final Path target;
    private final Path staging;

    /**
     * Makes the directory to write into, so that a target that cannot be written is found out before the work.
     *
     * @throws InputException when the target is a file or cannot be written
     */
    OutputDirectory(Path target) {
        this.target = target.toAbsolutePath().normalize();
        Path parent = this.target.getParent();
        if (parent == null) {
            throw new InputException("output directory " + target + " is the root of a file system");
        }
        for (Path place = this.target; place != null; place = place.getParent()) {
            if (Files.exists(place) && !Files.isDirectory(place)) {
                throw new InputException("output directory " + target + " cannot be written: " + place + " is a file");
            }
        }
        try {
            Files.createDirectories(parent);
            if (Files.isDirectory(this.target) && !Files.isWritable(this.target)) {
                throw new InputException("output directory " + target + " cannot be written: no permission");
            }
            this.staging = Files.createTempDirectory(parent, ".partial-" + this.target.getFileName() + "-");
        } catch (IOException e) {
            throw new InputException("output directory " + target + " cannot be written: " + reason(e), e);
        }
    }

    private static String reason(IOException problem) {
        String why = problem instanceof FileSystemException known ? known.getReason() : problem.getMessage();
        return why == null ? problem.getClass().getSimpleName() : why;
    }

    /** Where to write a file, given by its path inside the directory; its folders are made. */
    Path file(String relative) throws IOException {
        return withFolder(staging.resolve(relative));
    }

    /** The files that were written in a folder of the directory so far, in the order of their names. */
    List<Path> filesIn(String folder) throws IOException {
        Path place = staging.resolve(folder);
        return Files.isDirectory(place) ? filesIn(place) : List.of();
    }

    /**
     * Moves all that was written into place.
     *
     * @param obsolete files of an earlier run that must not stay if they were not written anew
     */
    void publish(List<String> obsolete) throws IOException {
        Files.createDirectories(target);
        for (String name : obsolete) {
            Files.deleteIfExists(target.resolve(name));
        }
        for (Path file : filesIn(staging)) {
            Path place = withFolder(target.resolve(staging.relativize(file)));
            Files.move(file, place, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
        }
    }

    private static Path withFolder(Path file) throws IOException {
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        return file;
    }

    private static List<Path> filesIn(Path directory) throws IOException {
        try (Stream<Path> files = Files.walk(directory)) {
            return files.filter(Files::isRegularFile).sorted().toList();
        }
    }

    /** Removes what was not published. */
    @Override
    public void close() {
        try (Stream<Path> files = Files.walk(staging)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        } catch (IOException e) {
            throw new UncheckedIOException("temporary directory " + staging + " cannot be removed", e);
        }
    }
}
