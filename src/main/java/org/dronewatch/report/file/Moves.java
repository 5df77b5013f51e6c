package org.dronewatch.report.file;

import java.io.IOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Objects;
import java.util.stream.Stream;

/** Moves of files that can be undone together, so that a write that fails changes nothing. */
final class Moves {
    private final Deque<Undo> done = new ArrayDeque<>();

    @FunctionalInterface
    private interface Undo {
        void run() throws IOException;
    }

    /** Moves a file to its target; an existing file there is kept elsewhere. */
    void move(Path file, Path target, Path kept) throws IOException {
        makeDirectories(target.getParent());
        if (Files.exists(target, LinkOption.NOFOLLOW_LINKS)) {
            setAside(target, kept);
        } else {
            done.push(() -> Files.deleteIfExists(target));
        }
        rename(file, target);
    }

    /** Removes a file. */
    void setAside(Path file, Path kept) throws IOException {
        if (Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS)) {
            throw new FileSystemException(file.toString(), null, file.getFileName() + " in it is a directory");
        }
        Files.createDirectories(Objects.requireNonNull(kept.getParent()));
        rename(file, kept);
        done.push(() -> rename(kept, file));
    }

    /**
     * Removes a directory if it is empty, and the directories above it that become empty as a result, up to but not
     * including a given one.
     */
    void removeIfEmpty(Path directory, Path last) throws IOException {
        Path here = directory;
        while (here.startsWith(last) && !here.equals(last) && isEmptyDirectory(here)) {
            Path removed = here;
            Files.delete(removed);
            done.push(() -> Files.createDirectory(removed));
            here = Objects.requireNonNull(removed.getParent());
        }
    }

    private static boolean isEmptyDirectory(Path path) throws IOException {
        if (!Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS)) {
            return false;
        }
        try (Stream<Path> inside = Files.list(path)) {
            return inside.findAny().isEmpty();
        }
    }

    /** Creates a directory and its missing parents. */
    void makeDirectories(Path directory) throws IOException {
        if (directory != null && !Files.isDirectory(directory)) {
            makeDirectories(directory.getParent());
            Files.createDirectories(directory);
            done.push(() -> Files.deleteIfExists(directory));
        }
    }

    private static void rename(Path file, Path target) throws IOException {
        try {
            Files.move(file, target, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            // A directory within the target may lie on another disk.
            Files.move(file, target, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Undoes all moves, the last first; moves that cannot be undone are noted in the exception. */
    void takeBack(Exception problem) {
        while (!done.isEmpty()) {
            try {
                done.pop().run();
            } catch (IOException e) {
                problem.addSuppressed(e);
            }
        }
    }
}
