package org.dronewatch.catalog;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Spelling;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;
import org.dronewatch.setting.input.BoundedFile;

/**
 * Real sensors by name: those of the library, and those of the user, each a file {@code NAME.yaml} beside the scene
 * file. A user's entry takes precedence over a packaged one with the same name.
 */
public final class Catalog implements Kinds.NamedSettings {
    private static final String ENDING = ".yaml";
    private static final String NAME = "[A-Za-z0-9_-]{1,64}";
    private static final int MAX_FILES = 1000;
    /** The largest file whose name is suggested; the packaged entries are about 3000 bytes long. */
    private static final int MAX_BYTES = 1 << 16;

    private static final List<String> PACKAGED = List.of(
            "blighter-a400",
            "blighter-a400-m10s",
            "spotterrf-c550",
            "spotterrf-c550ext",
            "droneshield-radarone",
            "droneshield-rfone",
            "droneshield-v2",
            "droneshield-widealert",
            "microphone-array-64",
            "droneshield-droneopt",
            "droneshield-droneheat",
            "cooled-thermal-camera",
            "cooled-thermal-camera-tele",
            "piranha-46-hr",
            "piranha-46-hr-tele");

    private static final List<String> SYSTEMS = List.of("droneshield-sentry", "liteye");

    private final Optional<Path> directory;
    private final Set<Path> read = Collections.synchronizedSet(new LinkedHashSet<>());
    private final FormerNames formerNames = new FormerNames();

    private Catalog(Optional<Path> directory) {
        this.directory = directory;
    }

    /** The library's sensors. */
    public static Catalog packaged() {
        return new Catalog(Optional.empty());
    }

    /** The library's sensors and those defined by files in a directory. */
    public static Catalog beside(Path directory) {
        return new Catalog(Optional.of(directory));
    }

    /** The names of the library's entries, in the order in which they are listed. */
    public static List<String> packagedNames() {
        return PACKAGED;
    }

    /** The names of systems of several sensors, in the order in which they are listed. */
    public static List<String> systemNames() {
        return SYSTEMS;
    }

    /** A system of several sensors; empty when the library has none of this name. */
    public static Optional<SensorSystem> system(String name) {
        return SYSTEMS.contains(name)
                ? Optional.of(SettingsFile.read(
                        resource("system/" + name + ENDING),
                        SensorSystem.class,
                        Kinds.FOUND,
                        Path.of(""),
                        new FormerNames()))
                : Optional.empty();
    }

    @Override
    public Map<String, Node.Mapping> partsOf(String name) {
        return ownFile(name).isPresent()
                ? Map.of()
                : system(name).map(SensorSystem::sensors).orElse(Map.of());
    }

    /** The user's files that have been read so far, in the order in which they were read. */
    public List<Path> filesRead() {
        synchronized (read) {
            return List.copyOf(read);
        }
    }

    /** The settings given under a former name in the files read so far. */
    public FormerNames formerNames() {
        return formerNames;
    }

    @Override
    public Set<String> names() {
        Set<String> names = new LinkedHashSet<>(PACKAGED);
        names.addAll(SYSTEMS);
        if (directory.isPresent()) {
            try (Stream<Path> files = Files.list(directory.get())) {
                files.filter(file -> file.toString().endsWith(ENDING))
                        .limit(MAX_FILES)
                        .filter(Catalog::looksLikeAnEntry)
                        .map(file -> String.valueOf(file.getFileName()))
                        .sorted()
                        .forEach(name -> names.add(name.substring(0, name.length() - ENDING.length())));
            } catch (IOException | UncheckedIOException e) {
                // Only what could be suggested is lost.
                return names;
            }
        }
        return names;
    }

    /** Scene files lie in the same directory; only files that may be entries are suggested. */
    private static boolean looksLikeAnEntry(Path file) {
        try {
            String text = new String(BoundedFile.read(file, MAX_BYTES), StandardCharsets.UTF_8);
            return text.lines().anyMatch(line -> line.startsWith("sensor:"));
        } catch (InputException e) {
            return false;
        }
    }

    @Override
    public Optional<Node.Mapping> find(String name) {
        return entry(name).map(CatalogEntry::sensor);
    }

    /**
     * The entry of a sensor; empty when there is none of this name.
     *
     * @throws InputException when its file is invalid
     */
    public Optional<CatalogEntry> entry(String name) {
        Path start = directory.orElse(Path.of(""));
        return document(name)
                .map(document -> SettingsFile.read(document, CatalogEntry.class, Kinds.FOUND, start, formerNames));
    }

    /**
     * The settings of a sensor.
     *
     * @param name the name of an entry of this catalogue, or of a kind, whose default settings then apply
     * @param parts settings that the entry does not state or that are overridden, by name: at least the position
     * @throws InputException if there is no such sensor, or the settings do not fit
     */
    public SensorSettings<?> settings(String name, Map<String, ?> parts) {
        if (!partsOf(name).isEmpty()) {
            throw new InputException("'" + name
                    + "' is a system of several sensors: a scene file uses it with 'use: " + name
                    + "', and --set sensors.ID=" + name + " replaces the sensor or system ID with it");
        }
        Node.Mapping known = find(name)
                .or(() -> ofKind(name))
                .orElseThrow(() -> new InputException(
                        "no sensor '" + name + "' in the catalogue; " + Spelling.closestMatches(name, choices())));
        Node.Mapping all = known.overlaidWith(Node.Mapping.ofReady(name, parts));
        Path start = directory.orElse(Path.of(""));
        return SettingsFile.read(all, SensorSettings.class, SensorKinds.kinds(this), start, formerNames);
    }

    /**
     * The sensors of a system, as if a scene file contained it.
     *
     * @param id the name of the system in the scene; its part {@code radar} is then named {@code ID-radar}
     * @param name name of the system, as accepted by {@link #partsOf}
     * @param position position of all sensors of the system, m
     * @throws InputException when one of its entries is invalid
     */
    public Map<String, SensorSettings<?>> settingsOfSystem(String id, String name, Position position) {
        Node.Mapping placed =
                Node.Mapping.ofUse(name).overlaidWith(Node.Mapping.ofReady(name, Map.of("position", position)));
        Node.Mapping scene =
                Node.Mapping.ofNodes(name, Map.of("sensors", Node.Mapping.ofNodes(name, Map.of(id, placed))));
        Path start = directory.orElse(Path.of(""));
        return SettingsFile.read(scene, Placed.class, SensorKinds.kinds(this), start, formerNames)
                .sensors();
    }

    /** Sensors as a scene has them. */
    private record Placed(Map<String, SensorSettings<?>> sensors) {}

    /** The names that {@link #settings} takes. */
    private Set<String> choices() {
        Set<String> choices = new TreeSet<>(names());
        choices.addAll(SensorKinds.all().keySet());
        return choices;
    }

    /** A kind of sensor without any settings. */
    private static Optional<Node.Mapping> ofKind(String name) {
        return SensorKinds.all().containsKey(name) ? Optional.of(Node.Mapping.ofKind(name)) : Optional.empty();
    }

    /**
     * The name of the library entry to which a sensor corresponds: an entry of the same kind whose stated settings all
     * equal those of the sensor; if there are several, the one that states the most; empty if there is none. The
     * sensor's position, aim and detection function do not matter.
     */
    public static Optional<String> nameOf(SensorSettings<?> sensor) {
        Optional<String> best = Optional.empty();
        int most = 0;
        for (StatedSettings entry : StatedSettings.OF_LIBRARY) {
            int parts = entry.agreeing(sensor);
            if (parts > most) {
                most = parts;
                best = Optional.of(entry.name());
            }
        }
        return best;
    }

    private Optional<Node.Mapping> document(String name) {
        if (!name.matches(NAME)) {
            return Optional.empty();
        }
        Optional<Path> own = ownFile(name);
        if (own.isPresent()) {
            read.add(own.get());
            return own.map(SettingsFile::document);
        }
        return PACKAGED.contains(name) ? Optional.of(resource(name + ENDING)) : Optional.empty();
    }

    /**
     * The user's file of a name: whatever has the name is used, even if it cannot be read as a file, which the message
     * then states.
     */
    private Optional<Path> ownFile(String name) {
        return name.matches(NAME)
                ? directory.map(folder -> folder.resolve(name + ENDING)).filter(Files::exists)
                : Optional.empty();
    }

    /** Reads a file of the library. */
    static CatalogEntry entryOf(Node.Mapping document) {
        return SettingsFile.read(document, CatalogEntry.class, Kinds.FOUND, Path.of(""), new FormerNames());
    }

    /** A file of the library. */
    static Node.Mapping resource(String file) {
        try (InputStream in = Catalog.class.getResourceAsStream(file)) {
            if (in == null) {
                throw new IllegalStateException("resource " + file + " is missing");
            }
            return SettingsFile.document(file, in);
        } catch (IOException e) {
            throw new IllegalStateException("resource " + file + " cannot be read", e);
        }
    }
}
