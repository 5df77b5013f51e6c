package org.dronewatch.setting;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/**
 * Collects the locations of settings given under a former name, so that each such name gives only one warning.
 * Thread-safe.
 */
public final class FormerNames {
    private final Map<Renamed, Set<String>> places = new LinkedHashMap<>();

    /**
     * A setting that had another name in earlier versions.
     *
     * @param record the settings record that has the setting
     * @param former the former name of the setting
     * @param current the current name of the setting
     */
    public record Renamed(Class<?> record, String former, String current) {}

    /**
     * Adds a setting given under a former name; the same location counts once.
     *
     * @param form form of the record that has the setting
     * @param former the name used
     * @param place location of the name: file, line and column, or the option
     */
    public synchronized void add(SettingsForm form, String former, String place) {
        Renamed setting = new Renamed(form.type(), former, form.currentName(former));
        places.computeIfAbsent(setting, one -> new LinkedHashSet<>()).add(place);
    }

    /** Adds the contents of another collection. */
    public void addAll(FormerNames others) {
        others.copy().forEach(this::addAll);
    }

    private synchronized void addAll(Renamed setting, Set<String> where) {
        places.computeIfAbsent(setting, one -> new LinkedHashSet<>()).addAll(where);
    }

    private synchronized Map<Renamed, Set<String>> copy() {
        Map<Renamed, Set<String>> copy = new LinkedHashMap<>();
        places.forEach((setting, where) -> copy.put(setting, new LinkedHashSet<>(where)));
        return copy;
    }

    /** A line for each former name: its first location, the number of others, and the current name. */
    public Map<Renamed, String> warnings() {
        Map<Renamed, String> lines = new LinkedHashMap<>();
        copy().forEach((setting, where) -> lines.put(setting, line(setting, where)));
        return Collections.unmodifiableMap(lines);
    }

    private static String line(Renamed setting, Set<String> where) {
        int others = where.size() - 1;
        String more = others == 0
                ? ""
                : " (the former name is also used in " + others + (others == 1 ? " other place)" : " other places)");
        return where.iterator().next() + ": setting '" + setting.former() + "' is now called '" + setting.current()
                + "'" + more;
    }
}
