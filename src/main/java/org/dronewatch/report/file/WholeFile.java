package org.dronewatch.report.file;

import java.io.BufferedOutputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.UUID;
import java.util.regex.Pattern;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.RegularFile;

/** An output file named by the user: checked before any work is done, and written completely or not at all. */
public final class WholeFile {
    private static final int BUFFER_BYTES = 1 << 16;
    private static final int LONGEST_LINE_BYTES = 1 << 12;

    private final String asked;
    private final Path file;
    private final Path directory;

    /** Writes the file's contents. */
    @FunctionalInterface
    public interface Content {
        /** Writes all contents, without closing the stream. */
        void writeTo(OutputStream stream) throws IOException;
    }

    /** Writes the file's contents, where a library needs a file rather than a stream. */
    @FunctionalInterface
    public interface FileContent {
        /** Writes all contents into a new, empty file. */
        void writeTo(Path partial) throws IOException;
    }

    /**
     * An output file; nothing is written yet.
     *
     * @param option name of the option or setting in messages, such as {@code --out}
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
        this.directory = checkedDirectory();
    }

    private WholeFile(String asked, Path file) {
        this.asked = asked;
        this.file = file;
        this.directory = checkedDirectory();
    }

    private Path checkedDirectory() {
        Path parent = file.getParent();
        if (parent == null || Files.isDirectory(file)) {
            throw new InputException(asked + ": is a directory");
        }
        if (!Files.isDirectory(parent)) {
            throw new InputException(asked + ": there is no directory " + PlainText.value(parent));
        }
        if (!Files.isWritable(parent)) {
            throw new InputException(asked + ": no permission to write there");
        }
        return parent;
    }

    /**
     * This file, provided that it does not contain the work of a person or of another command. Links are resolved, so
     * that two names of the same file are one target, as with a directory of results.
     *
     * @param firstLine matches the first line of a file that may be replaced
     * @param writer name, in messages, of the command that writes such files, such as {@code 'save'}
     * @throws InputException when there is a file that must not be replaced
     */
    public WholeFile replacingOnly(Pattern firstLine, String writer) {
        if (!Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
            return this;
        }
        if (!Files.exists(file)) {
            throw new InputException(
                    asked + ": is a link to a file that does not exist: choose another file, or delete the link");
        }
        if (!firstLine.matcher(firstLine()).matches()) {
            throw new InputException(
                    asked + ": already exists, and " + writer + " did not write it: choose another file, or delete it");
        }
        try {
            return new WholeFile(asked, file.toRealPath());
        } catch (IOException e) {
            throw Refusal.of(asked, e);
        }
    }

    /** The first line of the file, or the beginning of a very long one; empty when it cannot be read as a file. */
    private String firstLine() {
        if (!RegularFile.obstacle(file).isEmpty()) {
            return "";
        }
        try (InputStream in = Files.newInputStream(file)) {
            String beginning = new String(in.readNBytes(LONGEST_LINE_BYTES), StandardCharsets.UTF_8);
            return beginning.lines().findFirst().orElse("");
        } catch (IOException e) {
            // What cannot be read is not known to be replaceable.
            return "";
        }
    }

    /** The file, as an absolute path. */
    public Path path() {
        return file;
    }

    /**
     * Writes the file; an older one is replaced.
     *
     * @throws InputException if writing fails; the older file is then unchanged
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
     * Writes the file; an older one is replaced. If {@code content} throws anything, the older file is unchanged.
     *
     * @throws InputException if writing fails; the older file is then unchanged
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
