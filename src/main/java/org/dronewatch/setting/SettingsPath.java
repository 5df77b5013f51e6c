package org.dronewatch.setting;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The path to one setting through a tree of records, such as {@code sensors.camera.fov} or {@code
 * world.models.0.scale}: names of record components, current or former ones, keys of maps and indices of lists,
 * separated by dots.
 */
public final class SettingsPath {
    /** The name under which scene files choose one of several kinds of settings. */
    private static final String KIND = "kind";

    private final String path;
    private final List<String> names;

    /** A path as users write it. */
    public SettingsPath(String path) {
        this.path = path;
        this.names = Arrays.asList(path.split("\\.", -1));
    }

    /**
     * The tree with another value at this path; every record along the path is created anew, so all limits are checked.
     *
     * @param tree settings
     * @param text the value, with or without a unit
     * @throws InputException when the path is invalid or the value does not fit
     */
    public <T> T write(T tree, String text) {
        @SuppressWarnings("unchecked")
        T changed = (T) Switches.at(tree, names)
                .<Object>map(toggle -> switched(toggle, (Record) tree, text))
                .orElseGet(() -> replaced(tree, tree, 0, text));
        return changed;
    }

    /**
     * The value at this path.
     *
     * @throws InputException when the path is invalid
     */
    public Object read(Object tree) {
        Optional<Switches> toggle = Switches.at(tree, names);
        if (toggle.isPresent()) {
            return toggle.get().isEnabled((Record) tree);
        }
        Object here = tree;
        for (int depth = 0; depth < names.size(); depth++) {
            here = child(tree, here, depth);
        }
        return here;
    }

    /** The quantity of the setting at this path; a plain number unless annotated. */
    public Quantity quantity(Object tree) {
        if (Switches.at(tree, names).isPresent()) {
            return Quantity.NUMBER;
        }
        Object here = tree;
        for (int depth = 0; depth < names.size() - 1; depth++) {
            here = child(tree, here, depth);
        }
        return here instanceof Record settings
                ? SettingText.quantity(component(tree, settings, names.size() - 1))
                : Quantity.NUMBER;
    }

    private Record switched(Switches toggle, Record settings, String text) {
        try {
            return toggle.with(settings, (boolean) SettingText.parse(boolean.class, Quantity.NUMBER, text));
        } catch (IllegalArgumentException e) {
            throw new InputException(path + "=" + text + ": " + e.getMessage(), e);
        }
    }

    private Object replaced(Object tree, Object here, int depth, String text) {
        if (depth == names.size()) {
            throw new InputException(path + "=" + PlainText.value(text) + ": '" + path
                    + "' is not a single value: name one of its parts");
        }
        Object unwrapped = here instanceof Optional<?> optional ? optional.orElse(null) : here;
        if (unwrapped instanceof Record settings) {
            Object changed = replacedInRecord(tree, settings, depth, text);
            return here instanceof Optional<?> ? Optional.of(changed) : changed;
        }
        Object next = replaced(tree, child(tree, unwrapped, depth), depth + 1, text);
        if (unwrapped instanceof Map<?, ?> map) {
            Map<Object, Object> copy = new LinkedHashMap<>(map);
            copy.put(names.get(depth), next);
            return copy;
        }
        List<Object> copy = new ArrayList<>((List<?>) unwrapped);
        copy.set(Integer.parseInt(names.get(depth)), next);
        return copy;
    }

    private Record replacedInRecord(Object tree, Record settings, int depth, String text) {
        RecordComponent part = component(tree, settings, depth);
        Object value;
        if (depth == names.size() - 1) {
            value = parsed(part, text);
        } else if (depth == names.size() - 2 && isOpen(part)) {
            Map<Object, Object> values = new LinkedHashMap<>((Map<?, ?>) SettingsForm.get(settings, part));
            values.put(names.get(depth + 1), ofOpen(part, text));
            value = values;
        } else {
            value = replaced(tree, SettingsForm.get(settings, part), depth + 1, text);
        }
        try {
            return SettingsForm.with(settings, part.getName(), value);
        } catch (IllegalArgumentException e) {
            throw new InputException(path + "=" + PlainText.value(text) + ": " + e.getMessage(), e);
        }
    }

    /** Whether a part holds texts or numbers by name, to which any name may be added. */
    private static boolean isOpen(RecordComponent part) {
        return part.getGenericType() instanceof ParameterizedType type
                && type.getRawType() == Map.class
                && (type.getActualTypeArguments()[1] == String.class
                        || type.getActualTypeArguments()[1] == Double.class);
    }

    private Object ofOpen(RecordComponent part, String text) {
        try {
            Type kind = ((ParameterizedType) part.getGenericType()).getActualTypeArguments()[1];
            return SettingText.parse(kind, SettingText.quantity(part), text);
        } catch (IllegalArgumentException e) {
            throw new InputException(path + "=" + PlainText.value(text) + ": " + e.getMessage(), e);
        }
    }

    private Object parsed(RecordComponent target, String text) {
        try {
            Object value = SettingText.parse(target, text);
            Limits.check(target, value);
            return value;
        } catch (IllegalArgumentException e) {
            throw new InputException(path + "=" + PlainText.value(text) + ": " + e.getMessage(), e);
        }
    }

    private Object child(Object tree, Object here, int depth) {
        String name = names.get(depth);
        Object unwrapped = here instanceof Optional<?> optional ? optional.orElse(null) : here;
        if (unwrapped instanceof Record settings) {
            return SettingsForm.get(settings, component(tree, settings, depth));
        }
        if (unwrapped instanceof Map<?, ?> map) {
            if (!map.containsKey(name)) {
                List<String> known = map.keySet().stream().map(String::valueOf).toList();
                throw unknown(depth, has(known) + Spelling.didYouMean(name, known));
            }
            return map.get(name);
        }
        if (unwrapped instanceof List<?> list) {
            if (!name.matches("\\d{1,6}") || Integer.parseInt(name) >= list.size()) {
                throw unknown(
                        depth,
                        list.isEmpty()
                                ? "is an empty list"
                                : "is a list with "
                                        + (list.size() == 1
                                                ? "the single index 0"
                                                : "indices 0 to " + (list.size() - 1)));
            }
            return list.get(Integer.parseInt(name));
        }
        throw unknown(depth, unwrapped == null ? "is not set" + wholeOf(tree, depth) : "is a single value");
    }

    /** How to set, as a whole, the setting at a depth, which is not set. */
    private String wholeOf(Object tree, int depth) {
        Object parent = tree;
        for (int above = 0; above < depth - 1; above++) {
            parent = child(tree, parent, above);
        }
        Object holder = parent instanceof Optional<?> optional ? optional.orElse(null) : parent;
        return holder instanceof Record settings
                ? ": " + WholeSetting.unset(upTo(depth), component(tree, settings, depth - 1))
                : "";
    }

    private static String has(List<String> known) {
        return known.isEmpty() ? "is empty" : "has: " + String.join(", ", known);
    }

    private RecordComponent component(Object tree, Record settings, int depth) {
        SettingsForm form = SettingsForm.of(settings.getClass());
        return form.part(form.currentName(names.get(depth))).orElseThrow(() -> {
            Optional<String> kind = names.get(depth).equals(KIND)
                    ? WholeSetting.kind(upTo(depth), settings.getClass())
                    : Optional.empty();
            if (kind.isPresent()) {
                return new InputException("setting '" + path + "': " + kind.get());
            }
            List<String> more = Switches.at(tree, withLast(depth, Switchable.ENABLED))
                    .map(toggle -> List.of(Switchable.ENABLED))
                    .orElse(List.of());
            List<String> known = new ArrayList<>(form.names());
            known.addAll(more);
            return unknown(depth, has(known) + form.didYouMean(names.get(depth), more));
        });
    }

    /** The names up to a depth with another one there. */
    private List<String> withLast(int depth, String name) {
        List<String> path = new ArrayList<>(names.subList(0, depth));
        path.add(name);
        return path;
    }

    private String upTo(int depth) {
        return String.join(".", names.subList(0, depth));
    }

    private InputException unknown(int depth, String what) {
        String parent = depth == 0 ? "the scene" : "'" + upTo(depth) + "'";
        return new InputException(
                "setting '" + path + "': there is no '" + names.get(depth) + "'; " + parent + " " + what);
    }

    @Override
    public String toString() {
        return path;
    }
}
