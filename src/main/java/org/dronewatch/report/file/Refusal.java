package org.dronewatch.report.file;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.dronewatch.parallel.Interrupts;
import org.dronewatch.setting.InputException;

/** Describes a write that failed: the disk is full, read-only, or gone. */
final class Refusal {
    private Refusal() {}

    /**
     * A problem as shown to the user: one line for a write error, however libraries wrapped it.
     *
     * @param what the option and its value, or the directory
     */
    static RuntimeException of(String what, Exception problem) {
        if (problem instanceof InputException || problem instanceof CancellationException) {
            return (RuntimeException) problem;
        }
        if (Interrupts.isIn(problem)) {
            CancellationException interrupted = new CancellationException("interrupted while a file was being written");
            interrupted.initCause(problem);
            return interrupted;
        }
        Optional<IOException> behind = behind(problem);
        if (behind.isPresent()) {
            return new InputException(what + ": cannot be written: " + reason(behind.get()), problem);
        }
        return problem instanceof RuntimeException known ? known : new IllegalStateException(problem);
    }

    private static Optional<IOException> behind(Throwable problem) {
        Optional<IOException> deepest = Optional.empty();
        for (Throwable cause = problem; cause != null; cause = cause.getCause()) {
            deepest = cause instanceof IOException refused ? Optional.of(refused) : deepest;
        }
        return deepest;
    }

    /** The reason in words, without the name of a temporary file. */
    static String reason(IOException problem) {
        if (problem instanceof FileAlreadyExistsException known) {
            return known.getFile() + " is a file";
        }
        if (problem instanceof NoSuchFileException) {
            return "no such directory";
        }
        if (problem instanceof AccessDeniedException) {
            return "permission denied";
        }
        String why = problem instanceof FileSystemException known ? known.getReason() : problem.getMessage();
        if (problem instanceof FileNotFoundException && why != null) {
            // Its message is the name of the file and, in parentheses, what the system says.
            why = why.replaceFirst("^.*\\((.*)\\)$", "$1");
        }
        return why == null ? problem.getClass().getSimpleName() : why;
    }
}
