package org.dronewatch.setting;

import java.lang.reflect.Array;
import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The canonical text of a settings record, equal for equal settings on every machine: a line {@code path=value} for
 * each value, in the order of the record, numbers as in {@link Double#toString(double)}, and a line with the type of
 * each nested record and the size of each collection.
 */
public final class CanonicalSettings {
    private final StringBuilder text = new StringBuilder();

    private CanonicalSettings() {}

    /** All lines, each ended by a line feed. */
    public static String of(Record settings) {
        CanonicalSettings canonical = new CanonicalSettings();
        canonical.parts("", settings);
        return canonical.text.toString();
    }

    private void parts(String path, Record settings) {
        // All of them, including those that people do not write themselves.
        for (RecordComponent part : settings.getClass().getRecordComponents()) {
            String name = path.isEmpty() ? part.getName() : path + "." + part.getName();
            add(name, SettingsForm.get(settings, part));
        }
    }

    private void add(String path, Object value) {
        if (value instanceof Optional<?> optional) {
            optional.ifPresentOrElse(inside -> add(path, inside), () -> line(path, "none"));
        } else if (value instanceof Record record) {
            line(path, record.getClass().getSimpleName());
            parts(path, record);
        } else if (value instanceof Map<?, ?> map) {
            line(path, "map of " + map.size());
            map.forEach((key, inside) -> add(path + "." + key, inside));
        } else if (value instanceof Set<?> set) {
            line(path, "set of " + set.size());
            set.stream().map(CanonicalSettings::plain).sorted().forEach(inside -> line(path, inside));
        } else if (value instanceof List<?> list) {
            line(path, "list of " + list.size());
            for (int i = 0; i < list.size(); i++) {
                add(path + "." + i, list.get(i));
            }
        } else if (value != null && value.getClass().isArray()) {
            line(path, "list of " + Array.getLength(value));
            for (int i = 0; i < Array.getLength(value); i++) {
                add(path + "." + i, Array.get(value, i));
            }
        } else {
            line(path, plain(value));
        }
    }

    /** Other objects are written as their type: their own text may contain a memory address. */
    private static String plain(Object value) {
        if (value == null) {
            return "none";
        }
        if (value instanceof Enum<?> constant) {
            return constant.name();
        }
        boolean written = value instanceof Number || value instanceof CharSequence || value instanceof Boolean;
        if (written) {
            return value.toString();
        }
        Class<?> type = value.getClass();
        return type.isHidden() ? "function" : type.getName();
    }

    private void line(String path, String value) {
        text.append(path)
                .append('=')
                .append(value.replace("\\", "\\\\").replace("\n", "\\n"))
                .append('\n');
    }
}
