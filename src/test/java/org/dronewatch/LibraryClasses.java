package org.dronewatch;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.app.Main;

/** The compiled classes of the program itself, which is faster than to import them for rules of architecture. */
public final class LibraryClasses {
    private static final String SUFFIX = ".class";

    private LibraryClasses() {}

    /** All classes, those in others and without a name among them; none of them is initialised. */
    public static List<Class<?>> all() throws IOException {
        Path root = root();
        try (Stream<Path> files = Files.walk(root)) {
            return files.filter(file -> file.toString().endsWith(SUFFIX))
                    .map(root::relativize)
                    .<Class<?>>map(LibraryClasses::load)
                    .toList();
        }
    }

    private static Path root() {
        try {
            return Path.of(Main.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Class<?> load(Path file) {
        StringBuilder name = new StringBuilder();
        for (Path part : file) {
            name.append(name.isEmpty() ? "" : ".").append(part);
        }
        name.setLength(name.length() - SUFFIX.length());
        try {
            return Class.forName(name.toString(), false, Main.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }
}
