package org.dronewatch.run.model;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.dronewatch.flight.FlightsFile;
import org.dronewatch.flight.file.FlightFromFile;
import org.dronewatch.flight.file.FlightSource;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.setting.input.LinkOut;

/** Reads each file of flights once. For use by one thread at a time. */
final class FlightFiles {
    private final Path directory;
    private final BiConsumer<String, FileHash> hashes;
    private final Consumer<String> notes;
    private final Map<String, FlightsFile> recorded = new HashMap<>();
    private final Map<FlightFromFile, FlightSource> sources = new HashMap<>();

    /**
     * Begins without any files.
     *
     * @param directory directory against which relative paths are resolved
     * @param hashes receives the name and the hash of each file that is read
     * @param notes receives a line for each file that is read
     */
    FlightFiles(Path directory, BiConsumer<String, FileHash> hashes, Consumer<String> notes) {
        this.directory = directory;
        this.hashes = hashes;
        this.notes = notes;
    }

    /**
     * The flights that a run recorded.
     *
     * @param file its name in the settings
     * @throws InputException when it cannot be read, or is invalid
     */
    FlightsFile recorded(String file) {
        FlightsFile known = recorded.get(file);
        if (known == null) {
            known = FlightsFile.read(found(file), file);
            recorded.put(file, known);
            hashes.accept(file, known.hash());
            notes.accept("read " + file);
        }
        return known;
    }

    /**
     * A flight from a file of another program.
     *
     * @throws InputException when it cannot be read, or is invalid
     */
    FlightSource of(FlightFromFile settings) {
        FlightSource known = sources.get(settings);
        if (known == null) {
            known = settings.read(found(settings.file()), settings.file());
            sources.put(settings, known);
            hashes.accept(settings.file(), known.hash());
            notes.accept("read " + known.description());
        }
        return known;
    }

    private Path found(String file) {
        Path path;
        try {
            path = directory.resolve(file);
        } catch (InvalidPathException e) {
            throw new InputException(PlainText.value(file) + ": not a path: " + e.getReason(), e);
        }
        if (Files.exists(path)) {
            LinkOut.refuse(directory, path, "file");
        }
        return path;
    }
}
