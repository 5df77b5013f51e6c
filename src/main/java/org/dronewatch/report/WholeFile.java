package org.dronewatch.report;

import java.io.BufferedOutputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.UUID;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** A file that the user named for output: checked before any work is done, and written whole or not at all. */
public final class WholeFile {
    private static final int BUFFER_BYTES = 1 << 16;

    private final String asked;
    private final Path file;
    private final Path directory;

    /** Writes the file's contents. */
    @FunctionalInterface
    public interface Content {
        /** Writes all of it; closing the stream is not its business. */
        void writeTo(OutputStream stream) throws IOException;
    }

    /** Writes the file's contents, where a library needs a file rather than a stream. */
    @FunctionalInterface
    public interface FileContent {
        /** Writes all of it into a new, empty file. */
        void writeTo(Path partial) throws IOException;
    }

    /**
     * Names a file.
     *
     * @param option what messages call the setting that holds the name, such as {@code --out}
     * @param name the file's path as the user wrote it
     * @throws InputException when no file can be written there
     */
    public WholeFile(String option, String name) {
        this.asked = option + " " + PlainText.value(name);
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
            throw new InputException(asked + ": there is no directory " + PlainText.value(directory));
        }
        if (!Files.isWritable(directory)) {
            throw new InputException(asked + ": no permission to write there");
        }
    }

    /** The file, from the root on. */
    public Path path() {
        return file;
    }

    /**
     * Writes the file; an older one is replaced.
     *
     * @throws InputException if writing fails; the older file is then as it was
     */
    public void write(Content content) {
        writeFile(partial -> writeTo(partial, content));
    }

    private static void writeTo(Path partial, Content content) throws IOException {
        // Not a channel, because an interrupt would close it.
        FileOutputStream bytes = new FileOutputStream(partial.toFile());
        try (CarefulStream careful = new CarefulStream(bytes);
                OutputStream stream = new BufferedOutputStream(careful, BUFFER_BYTES)) {
            content.writeTo(stream);
            stream.flush();
            careful.check();
        }
    }

    /**
     * Writes the file; an older one is replaced. Whatever the content throws, the older file stays as it was.
     *
     * @throws InputException if writing fails; the older file is then as it was
     */
    public void writeFile(FileContent content) {
        // Not a temporary file of the library, which other users cannot read.
        Path partial = directory.resolve(".partial-" + UUID.randomUUID());
        try {
            Files.createFile(partial);
            content.writeTo(partial);
            Files.move(partial, file, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException | RuntimeException e) {
            throw Refusal.of(asked, e);
        } finally {
            remove(partial);
        }
    }

    private static void remove(Path partial) {
        try {
            Files.deleteIfExists(partial);
        } catch (IOException e) {
            // The file is there, or the disk has already been reported.
            return;
        }
    }
}
