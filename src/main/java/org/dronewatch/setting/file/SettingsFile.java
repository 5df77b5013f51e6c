package org.dronewatch.setting.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronewatch.setting.CanonicalSettings;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;

/** Reads settings records from YAML files written by hand, and writes such files. */
public final class SettingsFile {
    private SettingsFile() {}

    /**
     * Reads a file.
     *
     * @param file a file of at most 1 MiB, in UTF-8
     * @param type the type of record that the file describes
     * @param kinds kinds that a component of an interface type may have
     * @param used receives the settings that are written under a former name
     * @throws InputException with a line for each mistake: file, line, column, setting, value and limit
     */
    public static <T extends Record> T read(Path file, Class<T> type, Kinds kinds, FormerNames used) {
        Problems problems = new Problems();
        Node.Mapping document = YamlFile.read(file.toString(), YamlFile.text(file), problems);
        Path directory = file.resolveSibling("").toAbsolutePath();
        Optional<Object> settings = new SettingsReader(kinds, directory, used, problems).read(type, document);
        problems.throwIfAny();
        return type.cast(settings.orElseThrow(() -> new InputException(file + ": cannot be read")));
    }

    /**
     * The document of a file as nodes, not yet converted to settings.
     *
     * @throws InputException when it is not such a document
     */
    public static Node.Mapping document(Path file) {
        Problems problems = new Problems();
        Node.Mapping document = YamlFile.read(file.toString(), YamlFile.text(file), problems);
        problems.throwIfAny();
        return document;
    }

    /**
     * The document in a stream.
     *
     * @param name name of the stream in messages
     * @throws InputException when it is not such a document
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
     * @param directory directory against which relative file names are resolved
     * @param used receives the settings that are written under a former name
     * @throws InputException with a line for each mistake
     */
    public static <T> T read(Node.Mapping part, Class<T> type, Kinds kinds, Path directory, FormerNames used) {
        Problems problems = new Problems();
        Optional<Object> settings = new SettingsReader(kinds, directory, used, problems).read(type, part);
        problems.throwIfAny();
        return type.cast(settings.orElseThrow());
    }

    /**
     * The text of an equivalent YAML file for a record: numbers are exact and have units, and settings with their
     * default values are omitted.
     *
     * @param kinds kinds that a component of an interface type may have
     * @param from directory against which relative file names in the settings are resolved
     * @param file the file that is to hold the text; file names in the text are relative to the directory of that file
     * @return the text, which has been read back and is equal to the settings
     * @throws InputException when a setting cannot be written, or a file that it names is not in the directory of the
     *     new file or below that directory
     */
    public static <T extends Record> String text(T settings, Kinds kinds, Path from, Path file) {
        Path directory = file.toAbsolutePath().resolveSibling("");
        T moved = new RelocatedFiles(from, directory).of(settings);
        String text = YamlText.of(new SettingsWriter(kinds).write(moved));
        Problems problems = new Problems();
        Node.Mapping document = YamlFile.read(file.toString(), text, problems);
        Optional<Object> read =
                new SettingsReader(kinds, directory, new FormerNames(), problems).read(settings.getClass(), document);
        problems.throwIfAny();
        boolean isSame = read.equals(Optional.of(moved))
                || text.equals(YamlText.of(new SettingsWriter(kinds).write((Record) read.orElseThrow())));
        if (!isSame) {
            throw new InputException(file + ": what would be written reads back differently: "
                    + difference(moved, (Record) read.orElseThrow()));
        }
        return text;
    }

    /**
     * A record as a part of a document, as it would be written to a file.
     *
     * @param type the type of the setting that holds the record: the record's own type, or an interface with kinds
     * @param kinds kinds that a component of an interface type may have
     * @param from directory against which relative file names in the settings are resolved
     * @param file the file that is to hold the part; file names in the part are relative to the directory of that file
     * @throws InputException when a setting cannot be written, or a file that it names is not in the directory of the
     *     new file or below that directory
     */
    public static Node.Mapping part(Record settings, Class<?> type, Kinds kinds, Path from, Path file) {
        Record moved = new RelocatedFiles(from, file.toAbsolutePath().resolveSibling("")).of(settings);
        return new SettingsWriter(kinds).write(moved, type);
    }

    /**
     * A record as a part of a document with all its values, including those at their defaults.
     *
     * @param type the type of the setting that holds the record: the record's own type, or an interface with kinds
     * @param kinds kinds that a component of an interface type may have
     * @param from directory against which relative file names in the settings are resolved
     * @param file the file that is to hold the part; file names in the part are relative to the directory of that file
     * @throws InputException when a setting cannot be written, or a file that it names is not in the directory of the
     *     new file or below that directory
     */
    public static Node.Mapping wholePart(Record settings, Class<?> type, Kinds kinds, Path from, Path file) {
        Record moved = new RelocatedFiles(from, file.toAbsolutePath().resolveSibling("")).of(settings);
        return SettingsWriter.ofAll(kinds).write(moved, type);
    }

    private static String difference(Record wanted, Record read) {
        List<String> lines = CanonicalSettings.of(read).lines().toList();
        return CanonicalSettings.of(wanted)
                .lines()
                .filter(line -> !lines.contains(line))
                .findFirst()
                .orElse("a value of a kind that cannot be written as text");
    }
}
