package org.dronewatch.run.store;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;

/**
 * Where prepared sites are kept: the directory named by the system property {@value #PROPERTY}, or else by the
 * environment variable {@value #VARIABLE}, either of which may also be {@value #OFF}; if neither is set, the cache
 * directory of the platform.
 */
public final class StorePlace {
    /** The system property that names the directory, or turns the store off. */
    public static final String PROPERTY = "dronewatch.cache";

    /** The environment variable with the same meaning. */
    public static final String VARIABLE = "DRONEWATCH_CACHE";

    /** The value that turns the store off: nothing is kept. */
    public static final String OFF = "off";

    private static final String NAME = "dronewatch";

    private StorePlace() {}

    /** The directory of this process; empty if nothing is to be kept, or the user has no home. */
    static Optional<Path> directory() {
        return directory(System.getProperties(), System.getenv());
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
