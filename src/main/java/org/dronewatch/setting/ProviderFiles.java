package org.dronewatch.setting;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.JarURLConnection;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLConnection;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The files on the class path that name the providers of a service. If two jars contain the same class, Java loads it
 * from the first jar and never mentions the other: with an old and a new copy of a jar, the order of the class path
 * would decide what runs.
 */
final class ProviderFiles {
    private static final String DIRECTORY = "META-INF/services/";

    private final Map<String, Set<String>> places;

    private ProviderFiles(Map<String, Set<String>> places) {
        this.places = places;
    }

    /**
     * The files that a class loader finds.
     *
     * @throws InputException when one cannot be read
     */
    static ProviderFiles of(Class<?> service, ClassLoader loader) {
        Map<String, Set<String>> places = new LinkedHashMap<>();
        String name = DIRECTORY + service.getName();
        try {
            for (URL file : Collections.list(loader.getResources(name))) {
                String place = place(file, name);
                for (String provider : providers(file)) {
                    places.computeIfAbsent(provider, one -> new LinkedHashSet<>())
                            .add(place);
                }
            }
        } catch (IOException e) {
            throw new InputException("class path: " + PlainText.value(String.valueOf(e.getMessage())), e);
        }
        return new ProviderFiles(places);
    }

    private static List<String> providers(URL file) throws IOException {
        URLConnection connection = file.openConnection();
        // A cached jar stays open, and cannot be replaced on some systems.
        connection.setUseCaches(false);
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(connection.getInputStream(), StandardCharsets.UTF_8))) {
            return lines.lines()
                    .map(line -> line.replaceFirst("#.*", "").strip())
                    .filter(line -> !line.isEmpty())
                    .toList();
        }
    }

    /** The jar or directory in which a file of the class path lies. */
    private static String place(URL file, String name) throws IOException {
        try {
            if (file.openConnection() instanceof JarURLConnection jar) {
                return Path.of(jar.getJarFileURL().toURI()).toRealPath().toString();
            }
            Path path = Path.of(file.toURI()).toRealPath();
            return path.toString().substring(0, path.toString().length() - name.length());
        } catch (URISyntaxException | IllegalArgumentException | FileSystemNotFoundException e) {
            return file.toString();
        }
    }

    /**
     * Checks that no class of another project is on the class path twice. The library itself may be: its jar with all
     * dependencies beside the one without.
     *
     * @throws InputException when one is; the message, of one line, gives both locations
     */
    void checkDuplicates() {
        places.forEach((provider, where) -> {
            if (where.size() > 1 && !provider.startsWith("org.dronewatch.")) {
                throw new InputException("class path: provider " + PlainText.value(provider) + " is in "
                        + String.join(" and in ", where) + ": remove one of them from the class path");
            }
        });
    }
}
