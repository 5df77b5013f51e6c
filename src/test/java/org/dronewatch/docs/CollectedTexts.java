package org.dronewatch.docs;

import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.scenario.SettingTexts;
import tools.jackson.databind.json.JsonMapper;

/** Collects those of the sources' texts that are asked for, for a program without its sources. */
final class CollectedTexts implements SettingTexts {
    private final SettingTexts sources;
    private final Map<String, Map<String, String>> asked = new TreeMap<>();

    CollectedTexts(SettingTexts sources) {
        this.sources = sources;
    }

    /** By name of the class, then by component, the empty name for the record itself. */
    String write() {
        return JsonMapper.builder().build().writerWithDefaultPrettyPrinter().writeValueAsString(asked) + "\n";
    }

    @Override
    public String summary(Class<?> record) {
        return collected(record, "", sources.summary(record));
    }

    @Override
    public String part(Class<?> record, String component) {
        return collected(record, component, sources.part(record, component));
    }

    private String collected(Class<?> record, String component, String text) {
        if (!text.isEmpty()) {
            asked.computeIfAbsent(record.getName(), name -> new TreeMap<>()).put(component, text);
        }
        return text;
    }
}
