package org.dronewatch.report;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.UUID;
import org.dronewatch.setting.InputException;

/** A file that the user named for output: checked before any work is done, and written whole or not at all. */
public final class WholeFile {
    private static final int BUFFER_BYTES = 1 << 16;

    private final String asked;
    private final Path file;
    private final Path directory;

    /** Writes what the file is to hold. */
    @FunctionalInterface
    public interface Content {
        /** Writes all of it; closing the stream is not its business. */
        void writeTo(OutputStream stream) throws IOException;
    }

    /**
     * Names a file.
     *
     * @param option what messages call the setting that holds the name, such as {@code --out}
     * @param name the file's path as the user wrote it
     * @throws InputException when no file can be written there
     */
    public WholeFile(String option, String name) {
        this.asked = option + " " + name;
        try {
            this.file = Path.of(name).toAbsolutePath().normalize();
        } catch (InvalidPathException e) {
            throw new InputException(asked + ": not a path: " + e.getReason(), e);
        }
        this.directory = file.getParent();
        if (directory == null || Files.isDirectory(file)) {
            throw new InputException(asked + ": is a directory");
        }
        if (!Files.isDirectory(directory)) {
            throw new InputException(asked + ": there is no directory " + directory);
        }
        if (!Files.isWritable(directory)) {
            throw new InputException(asked + ": no permission to write there");
        }
    }

    /**
     * Writes the file; an older one is replaced.
     *
     * @throws InputException when the disk refuses; the older file is then as it was
     */
    public void write(Content content) {
        try {
            // Not a temporary file of the library, which nobody else may read.
            Path partial = directory.resolve(".partial-" + UUID.randomUUID());
            try {
                try (OutputStream stream = new BufferedOutputStream(
                        Files.newOutputStream(partial, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
                        BUFFER_BYTES)) {
                    content.writeTo(stream);
                }
                Files.move(partial, file, StandardCopyOption.REPLACE_EXISTING);
            } finally {
                Files.deleteIfExists(partial);
            }
        } catch (IOException e) {
            throw new InputException(asked + ": cannot be written: " + e.getMessage(), e);
        }
    }
}
