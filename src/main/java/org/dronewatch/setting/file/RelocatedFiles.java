package org.dronewatch.setting.file;

import java.io.File;
import java.lang.reflect.RecordComponent;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.OutsideFileException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.SettingsForm;

/** Makes the file names in settings relative to another directory, so that they refer to the same files as before. */
final class RelocatedFiles {
    private final Path from;
    private final Path to;

    /**
     * A change of the directory to which the file names in settings are relative.
     *
     * @param from the directory to which they are relative now
     * @param to the directory to which they will be relative
     */
    RelocatedFiles(Path from, Path to) {
        this.from = from.toAbsolutePath().normalize();
        this.to = to.toAbsolutePath().normalize();
    }

    /**
     * Settings with the new names.
     *
     * @throws InputException when a file is not in the new directory or below it, where a settings file may name it
     */
    <T extends Record> T of(T settings) {
        @SuppressWarnings("unchecked")
        T moved = (T) record(settings, "");
        return moved;
    }

    private Record record(Record settings, String path) {
        Map<String, Object> changed = new LinkedHashMap<>();
        for (RecordComponent part : SettingsForm.of(settings.getClass()).parts()) {
            Object value = SettingsForm.get(settings, part);
            String here = path.isEmpty() ? part.getName() : path + "." + part.getName();
            FileName rule = part.getAnnotation(FileName.class);
            Object moved = rule == null ? value(value, here) : names(value, rule, here);
            if (!moved.equals(value)) {
                changed.put(part.getName(), moved);
            }
        }
        return changed.isEmpty() ? settings : SettingsForm.with(settings, changed);
    }

    private Object value(Object value, String path) {
        if (value instanceof Optional<?> optional) {
            return optional.map(inside -> value(inside, path));
        }
        if (value instanceof List<?> list) {
            Object[] items = new Object[list.size()];
            for (int i = 0; i < items.length; i++) {
                items[i] = value(list.get(i), path + "." + i);
            }
            return List.of(items);
        }
        if (value instanceof Map<?, ?> map) {
            Map<Object, Object> values = new LinkedHashMap<>();
            map.forEach((key, inside) -> values.put(key, value(inside, path + "." + key)));
            return values;
        }
        boolean isWritten = value instanceof Node;
        return value instanceof Record settings && !isWritten ? record(settings, path) : value;
    }

    /** A name, an optional name, or a list of names. */
    private Object names(Object value, FileName rule, String path) {
        if (value instanceof Optional<?> optional) {
            return optional.map(inside -> names(inside, rule, path));
        }
        if (value instanceof List<?> list) {
            return list.stream().map(inside -> names(inside, rule, path)).toList();
        }
        return name(value.toString(), rule, path);
    }

    private String name(String name, FileName rule, String path) {
        if (!rule.unless().isEmpty() && name.startsWith(rule.unless())) {
            return name;
        }
        Path file = resolved(name, path);
        if (!file.startsWith(to)) {
            throw new OutsideFileException(
                    path + ": file '" + PlainText.value(file) + "' is neither in " + PlainText.value(to)
                            + " nor below it, so a scene file there cannot name it",
                    "write the scene into " + PlainText.value(file.getParent()) + " or a directory above it");
        }
        boolean isSameName = from.equals(to) && !Path.of(name).isAbsolute();
        return isSameName ? name : to.relativize(file).toString().replace(File.separatorChar, '/');
    }

    private Path resolved(String name, String path) {
        try {
            return from.resolve(name).normalize();
        } catch (InvalidPathException e) {
            throw new InputException(
                    path + ": file '" + PlainText.value(name) + "' is not a path: " + e.getReason(), e);
        }
    }
}
