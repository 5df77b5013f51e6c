package org.dronewatch.run.store;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;

/**
 * Where prepared sites are kept.
 *
 * @param directory directory of the store, created when it is first needed; empty to keep nothing
 */
public record StorePlace(Optional<Path> directory) {
    /** Nothing is kept. */
    public static final StorePlace NONE = new StorePlace(Optional.empty());

    /** The system property that names the directory, or turns the store off. */
    public static final String PROPERTY = "dronewatch.cache";

    /** The environment variable that names the directory, or turns the store off, unless the property is set. */
    public static final String VARIABLE = "DRONEWATCH_CACHE";

    /** The value that turns the store off. */
    private static final String OFF = "off";

    private static final String NAME = "dronewatch";

    /**
     * The place that the user has chosen for this process: the directory named by the system property
     * {@value #PROPERTY}, or else by the environment variable {@value #VARIABLE}, either of which may also be
     * {@code off}; if neither is set, the cache directory of the platform; nothing is kept if the user has no home
     * directory.
     */
    public static StorePlace ofProcess() {
        return new StorePlace(directory(System.getProperties(), System.getenv()));
    }

    static Optional<Path> directory(Properties properties, Map<String, String> environment) {
        String chosen = properties.getProperty(PROPERTY, environment.getOrDefault(VARIABLE, ""));
        if (chosen.equalsIgnoreCase(OFF)) {
            return Optional.empty();
        }
        if (!chosen.isBlank()) {
            return path(chosen).map(Path::toAbsolutePath);
        }
        String system = properties.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        if (system.startsWith("windows")) {
            return absolute(environment.get("LOCALAPPDATA"))
                    .map(local -> local.resolve(NAME).resolve("cache"));
        }
        Optional<Path> home = absolute(properties.getProperty("user.home")).filter(Files::isDirectory);
        if (system.startsWith("mac")) {
            return home.map(path -> path.resolve("Library").resolve("Caches").resolve(NAME));
        }
        return absolute(environment.get("XDG_CACHE_HOME"))
                .or(() -> home.map(path -> path.resolve(".cache")))
                .map(caches -> caches.resolve(NAME));
    }

    private static Optional<Path> absolute(String name) {
        return name == null ? Optional.empty() : path(name).filter(Path::isAbsolute);
    }

    private static Optional<Path> path(String name) {
        try {
            return Optional.of(Path.of(name));
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }
}
