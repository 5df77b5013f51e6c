package org.dronewatch.setting.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Optional;
import org.dronewatch.setting.InputException;

/** Reads a settings record from a YAML file that a person wrote. */
public final class SettingsFile {
    private SettingsFile() {}

    /**
     * Reads a file.
     *
     * @param file of at most 1 MiB, in UTF-8
     * @param type the record that it describes
     * @param kinds among which to choose where the record has an interface
     * @throws InputException with a line for each mistake: file, line, column, setting, value and limit
     */
    public static <T extends Record> T read(Path file, Class<T> type, Kinds kinds) {
        Problems problems = new Problems();
        Node.Mapping document = YamlFile.read(file.toString(), YamlFile.text(file), problems);
        Path directory = file.resolveSibling("").toAbsolutePath();
        Optional<Object> settings = new SettingsReader(kinds, directory, problems).read(type, document);
        problems.throwIfAny();
        return type.cast(settings.orElseThrow());
    }

    /**
     * The document of a file as nodes, unread.
     *
     * @throws InputException when it is no such document
     */
    public static Node.Mapping document(Path file) {
        Problems problems = new Problems();
        Node.Mapping document = YamlFile.read(file.toString(), YamlFile.text(file), problems);
        problems.throwIfAny();
        return document;
    }

    /**
     * The document that a stream holds.
     *
     * @param name what messages call it
     * @throws InputException when it is no such document
     * @throws IOException when the stream cannot be read
     */
    public static Node.Mapping document(String name, InputStream in) throws IOException {
        Problems problems = new Problems();
        Node.Mapping document = YamlFile.read(name, YamlFile.text(name, in), problems);
        problems.throwIfAny();
        return document;
    }

    /**
     * Reads a record from a part of a document.
     *
     * @param type a record, or an interface with kinds
     * @param directory where file names start
     * @throws InputException with a line for each mistake
     */
    public static <T> T read(Node.Mapping part, Class<T> type, Kinds kinds, Path directory) {
        Problems problems = new Problems();
        Optional<Object> settings = new SettingsReader(kinds, directory, problems).read(type, part);
        problems.throwIfAny();
        return type.cast(settings.orElseThrow());
    }
}
