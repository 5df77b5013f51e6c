package org.dronewatch.report.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronewatch.report.labels.Labels;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * A directory of results, the target, whose files appear all at once: they are first written into a temporary directory
 * and, at the end, moved into the target, either all of them or none. Whatever else the target holds is left unchanged.
 * Only one run at a time may write into a target.
 */
public final class OutputDirectory implements AutoCloseable {
    private static final Pattern LABEL = Pattern.compile("labels[/\\\\](run-\\d+[/\\\\])?[\\w-]+[/\\\\]\\d{6}\\.png");

    private final String asked;
    private final Path target;
    private final StagingLock lock;
    private final Path fresh;
    private final Path replaced;

    /** Work that writes into the directory. */
    @FunctionalInterface
    public interface Work {
        /** Writes the files. */
        void run() throws IOException;
    }

    /**
     * Creates the temporary directory, so that a target that cannot be written is detected before the work begins.
     * Anything that a killed run left in it is removed.
     *
     * @param given the target, which is created if missing
     * @throws InputException when the target is a file or cannot be written, or when another run is writing into it
     */
    public OutputDirectory(Path given) {
        this.asked = "output directory " + PlainText.value(given);
        Path absolute = given.toAbsolutePath().normalize();
        if (absolute.getParent() == null) {
            throw new InputException(asked + " is the root of a file system");
        }
        for (Path path = absolute; path != null; path = path.getParent()) {
            if (Files.exists(path) && !Files.isDirectory(path)) {
                throw new InputException(asked + " cannot be written: " + PlainText.value(path) + " is a file");
            }
        }
        try {
            // Links are resolved, so that two names of a directory are one target.
            this.target = Files.isDirectory(absolute) ? absolute.toRealPath() : absolute;
            if (Files.isDirectory(target) && !Files.isWritable(target)) {
                throw new InputException(asked + " cannot be written: no permission");
            }
            Path staging = stagingPlace();
            this.lock = StagingLock.acquire(staging)
                    .orElseThrow(() -> new InputException(
                            asked + " is in use by another run: wait until it finishes, or use another directory"));
            this.fresh = staging.resolve("new");
            this.replaced = staging.resolve("old");
        } catch (IOException e) {
            throw new InputException(asked + " cannot be written: " + Refusal.reason(e), e);
        }
    }

    /**
     * Where files are written first: beside the target; inside it if the place beside it is on another disk, from which
     * files cannot be moved into place, or must not be written to.
     */
    private Path stagingPlace() throws IOException {
        String name = ".partial-" + target.getFileName();
        Path parent = Objects.requireNonNull(target.getParent());
        Files.createDirectories(parent);
        boolean within = Files.isDirectory(target)
                && !(Files.isWritable(parent) && Files.getFileStore(parent).equals(Files.getFileStore(target)));
        return within ? target.resolve(name) : parent.toRealPath().resolve(name);
    }

    /**
     * Performs work that writes into the directory.
     *
     * @throws InputException if writing fails
     */
    public void write(Work work) {
        try {
            work.run();
        } catch (IOException | RuntimeException e) {
            throw refusal(e);
        }
    }

    /** The exception that reports a problem to the user; a write error is described in one line. */
    public RuntimeException refusal(Exception problem) {
        return Refusal.of(asked, problem);
    }

    /** Where to write a file, given by its path inside the directory; missing folders on that path are created. */
    public Path file(String relative) throws IOException {
        Path file = fresh.resolve(relative);
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        return file;
    }

    /** The files that have been written into a folder of the directory so far, in the order of their names. */
    public List<Path> filesIn(String folder) throws IOException {
        Path directory = fresh.resolve(folder);
        return Files.isDirectory(directory) ? filesIn(directory) : List.of();
    }

    /**
     * The label files that an earlier run left in the target, as paths within it: {@code coco.json}, and the pictures
     * whose names have the form that runs give them; empty if there is no {@code coco.json}.
     */
    public List<String> formerLabels() throws IOException {
        Path pictures = target.resolve(Labels.PICTURES);
        if (!Files.isRegularFile(target.resolve(Labels.COCO))) {
            return List.of();
        }
        List<String> former = new ArrayList<>(List.of(Labels.COCO));
        if (Files.isDirectory(pictures)) {
            filesIn(pictures).stream()
                    .map(file -> target.relativize(file).toString())
                    .filter(name -> LABEL.matcher(name).matches())
                    .forEach(former::add);
        }
        return former;
    }

    /**
     * The files of earlier results in the target whose names match a pattern.
     *
     * @param sign name of a file that marks the target as holding such results; if it is missing, the list is empty
     * @param names pattern of the file names
     */
    public List<String> former(String sign, Pattern names) throws IOException {
        if (!Files.isRegularFile(target.resolve(sign))) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(target)) {
            return files.map(file -> String.valueOf(file.getFileName()))
                    .filter(name -> names.matcher(name).matches())
                    .sorted()
                    .toList();
        }
    }

    /**
     * Moves all written files into place; if one cannot be moved, none is.
     *
     * @param obsolete files of an earlier run, as paths within the target, which are removed unless they were written
     *     anew, together with folders that held nothing else
     */
    public void publish(List<String> obsolete) throws IOException {
        Moves moves = new Moves();
        try {
            moves.makeDirectories(target);
            for (String name : obsolete) {
                if (Files.exists(target.resolve(name), LinkOption.NOFOLLOW_LINKS)) {
                    moves.setAside(target.resolve(name), replaced.resolve(name));
                }
            }
            for (Path file : filesIn(fresh)) {
                Path relative = fresh.relativize(file);
                moves.move(file, target.resolve(relative), replaced.resolve(relative));
            }
            for (String name : obsolete) {
                moves.removeIfEmpty(Objects.requireNonNull(target.resolve(name).getParent()), target);
            }
        } catch (IOException | RuntimeException e) {
            moves.takeBack(e);
            throw e;
        }
    }

    private static List<Path> filesIn(Path directory) throws IOException {
        try (Stream<Path> files = Files.walk(directory)) {
            return files.filter(Files::isRegularFile).sorted().toList();
        }
    }

    /** Removes unpublished files, and lets other runs write into the target. */
    @Override
    public void close() {
        lock.close();
    }
}
