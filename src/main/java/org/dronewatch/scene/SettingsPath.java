package org.dronewatch.scene;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;

/**
 * The way to one setting through a tree of records, such as {@code sensors.camera.fov} or {@code world.models.0.scale}:
 * names of record components, keys of maps and places in lists, with dots between.
 */
public final class SettingsPath {
    private final String path;
    private final List<String> names;

    /** A path as a person writes it. */
    public SettingsPath(String path) {
        this.path = path;
        this.names = Arrays.asList(path.split("\\.", -1));
    }

    /**
     * The tree with another value at this path; every record on the way is made anew, so all limits are checked.
     *
     * @param tree settings
     * @param text the value, with a unit or without
     * @throws InputException when the path leads nowhere or the value does not fit
     */
    public <T> T write(T tree, String text) {
        @SuppressWarnings("unchecked")
        T changed = (T) replaced(tree, 0, text);
        return changed;
    }

    /**
     * The value at this path.
     *
     * @throws InputException when the path leads nowhere
     */
    public Object read(Object tree) {
        Object here = tree;
        for (int depth = 0; depth < names.size(); depth++) {
            here = child(here, depth);
        }
        return here;
    }

    /** The quantity of the setting at this path: what it is measured in; a plain number if nothing is said. */
    public Quantity quantity(Object tree) {
        Object here = tree;
        for (int depth = 0; depth < names.size() - 1; depth++) {
            here = child(here, depth);
        }
        In annotation = here instanceof Record settings
                ? component(settings, names.size() - 1).getAnnotation(In.class)
                : null;
        return annotation == null ? Quantity.NUMBER : annotation.value();
    }

    private Object replaced(Object here, int depth, String text) {
        if (depth == names.size()) {
            throw new InputException(
                    path + "=" + text + ": '" + path + "' is not a single value: name one of its parts");
        }
        Object unwrapped = here instanceof Optional<?> optional ? optional.orElse(null) : here;
        if (unwrapped instanceof Record settings) {
            Object changed = replacedInRecord(settings, depth, text);
            return here instanceof Optional<?> ? Optional.of(changed) : changed;
        }
        Object next = replaced(child(unwrapped, depth), depth + 1, text);
        if (unwrapped instanceof Map<?, ?> map) {
            Map<Object, Object> copy = new LinkedHashMap<>(map);
            copy.put(names.get(depth), next);
            return copy;
        }
        List<Object> copy = new ArrayList<>((List<?>) unwrapped);
        copy.set(Integer.parseInt(names.get(depth)), next);
        return copy;
    }

    private Record replacedInRecord(Record settings, int depth, String text) {
        RecordComponent[] components = settings.getClass().getRecordComponents();
        String target = component(settings, depth).getName();
        Object[] values = new Object[components.length];
        for (int i = 0; i < components.length; i++) {
            values[i] = valueOf(settings, components[i]);
            if (components[i].getName().equals(target)) {
                values[i] =
                        depth == names.size() - 1 ? parsed(components[i], text) : replaced(values[i], depth + 1, text);
            }
        }
        return construct(settings.getClass(), components, values, text);
    }

    private Object parsed(RecordComponent target, String text) {
        try {
            return SettingValue.parse(target, text);
        } catch (IllegalArgumentException e) {
            throw new InputException(path + "=" + text + ": " + e.getMessage(), e);
        }
    }

    private Record construct(Class<?> type, RecordComponent[] components, Object[] values, String text) {
        Class<?>[] types =
                Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
        try {
            Constructor<?> constructor = type.getDeclaredConstructor(types);
            constructor.setAccessible(true);
            return (Record) constructor.newInstance(values);
        } catch (InvocationTargetException e) {
            throw new InputException(path + "=" + text + ": " + e.getCause().getMessage(), e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("settings record " + type.getName() + " cannot be made anew", e);
        }
    }

    private Object child(Object here, int depth) {
        String name = names.get(depth);
        Object unwrapped = here instanceof Optional<?> optional ? optional.orElse(null) : here;
        if (unwrapped instanceof Record settings) {
            return valueOf(settings, component(settings, depth));
        }
        if (unwrapped instanceof Map<?, ?> map) {
            if (!map.containsKey(name)) {
                throw unknown(
                        depth,
                        "has: "
                                + String.join(
                                        ", ",
                                        map.keySet().stream()
                                                .map(String::valueOf)
                                                .toList()));
            }
            return map.get(name);
        }
        if (unwrapped instanceof List<?> list) {
            if (!name.matches("\\d{1,6}") || Integer.parseInt(name) >= list.size()) {
                throw unknown(depth, "is a list with places 0 to " + (list.size() - 1));
            }
            return list.get(Integer.parseInt(name));
        }
        throw unknown(depth, unwrapped == null ? "is not set" : "is a single value");
    }

    private RecordComponent component(Record settings, int depth) {
        RecordComponent[] components = settings.getClass().getRecordComponents();
        return Arrays.stream(components)
                .filter(component -> component.getName().equals(names.get(depth)))
                .findFirst()
                .orElseThrow(() -> unknown(
                        depth,
                        "has: "
                                + String.join(
                                        ", ",
                                        Arrays.stream(components)
                                                .map(RecordComponent::getName)
                                                .toList())));
    }

    private InputException unknown(int depth, String what) {
        String parent = depth == 0 ? "the scene" : "'" + String.join(".", names.subList(0, depth)) + "'";
        return new InputException("setting '" + path + "': no '" + names.get(depth) + "': " + parent + " " + what);
    }

    private static Object valueOf(Record settings, RecordComponent component) {
        try {
            component.getAccessor().setAccessible(true);
            return component.getAccessor().invoke(settings);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("settings component " + component + " cannot be read", e);
        }
    }

    @Override
    public String toString() {
        return path;
    }
}
