package org.dronewatch.report.provenance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** Compares the files of two directories of results that must have the same bytes whenever the inputs are the same. */
public final class SameBytes {
    private static final Set<String> FILES = Set.of(
            "result.json",
            "detections.csv",
            "observations.csv",
            "flights.csv",
            "runs.csv",
            "sensitivity.csv",
            "campaign.json",
            "route.json",
            "place.json",
            "plan.json",
            "coco.json",
            "map.geojson",
            "map.kml");

    private static final int DEPTH = 4;

    private SameBytes() {}

    /** How a file compares with the earlier one. */
    public enum State {
        /** It has the same bytes. */
        SAME,
        /** Its bytes differ. */
        DIFFERENT,
        /** It is no longer there. */
        MISSING,
        /** It was not there before. */
        NEW
    }

    /**
     * Compares tables, results, maps, labels and pictures.
     *
     * @return the state of each file by its name, in the order of the names
     * @throws InputException when a file cannot be read
     */
    public static Map<String, State> compare(Path before, Path after) {
        try {
            Set<String> old = files(before);
            Set<String> all = new TreeSet<>(files(after));
            Map<String, State> states = new TreeMap<>();
            for (String name : old) {
                states.put(name, all.contains(name) ? state(before.resolve(name), after.resolve(name)) : State.MISSING);
            }
            all.forEach(name -> states.putIfAbsent(name, State.NEW));
            return Collections.unmodifiableMap(states);
        } catch (IOException e) {
            throw new InputException(
                    PlainText.value(before) + ": cannot be compared: " + PlainText.value(e.getMessage()), e);
        }
    }

    private static State state(Path one, Path other) throws IOException {
        return Files.mismatch(one, other) < 0 ? State.SAME : State.DIFFERENT;
    }

    private static Set<String> files(Path directory) throws IOException {
        Set<String> names = new TreeSet<>();
        try (Stream<Path> all = Files.walk(directory, DEPTH)) {
            all.filter(Files::isRegularFile)
                    .map(directory::relativize)
                    .filter(SameBytes::isCompared)
                    .forEach(file -> names.add(file.toString().replace('\\', '/')));
        }
        return names;
    }

    private static boolean isCompared(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return FILES.contains(name) || name.endsWith(".png") || name.endsWith(".pfm");
    }
}
