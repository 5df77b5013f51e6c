package org.dronewatch.setting.file;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.InOrder;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Switchable;

/**
 * Converts settings records to nodes, from which {@link SettingsReader} makes equal records. Numbers are written
 * exactly and with their units; settings that have their default value are left out.
 */
final class SettingsWriter {
    private static final Mark NOWHERE = new Mark("", 1, 1);

    private final Kinds kinds;
    private final boolean withDefaults;

    /**
     * A writer.
     *
     * @param kinds the names of the kinds of settings where a record has an interface
     */
    SettingsWriter(Kinds kinds) {
        this(kinds, false);
    }

    private SettingsWriter(Kinds kinds, boolean withDefaults) {
        this.kinds = kinds;
        this.withDefaults = withDefaults;
    }

    /** A writer that also writes settings that have their default value. */
    static SettingsWriter ofAll(Kinds kinds) {
        return new SettingsWriter(kinds, true);
    }

    /**
     * A record as a document.
     *
     * @throws InputException when something in it cannot be written in a file
     */
    Node.Mapping write(Record settings) {
        return mapping(parts(settings, ""));
    }

    /**
     * A record as a part of a document, with its kind if the setting that holds it is of a type with kinds.
     *
     * @throws InputException when something in it cannot be written in a file
     */
    Node.Mapping write(Record settings, Class<?> type) {
        return kinds.isChoice(type) ? choice(type, settings, "") : write(settings);
    }

    private Map<String, Node> parts(Record settings, String path) {
        SettingsForm form = SettingsForm.of(settings.getClass());
        Optional<Record> plain = byDefault(form, settings);
        Map<String, Node> written = new LinkedHashMap<>();
        for (RecordComponent part : form.parts()) {
            Object value = SettingsForm.get(settings, part);
            boolean isDefault = !form.required().contains(part.getName())
                    && plain.isPresent()
                    && Objects.equals(SettingsForm.get(plain.get(), part), value);
            if (!isDefault || withDefaults && !value.equals(Optional.empty())) {
                String here = path.isEmpty() ? part.getName() : path + "." + part.getName();
                Node node = node(value, part.getGenericType(), SettingText.quantity(part), here);
                written.put(part.getName(), switched(form, part, settings, node));
            }
        }
        return written;
    }

    /** The record with default values for all but the required components. */
    private static Optional<Record> byDefault(SettingsForm form, Record settings) {
        Map<String, Object> required = new LinkedHashMap<>();
        form.parts().stream()
                .filter(part -> form.required().contains(part.getName()))
                .forEach(part -> required.put(part.getName(), SettingsForm.get(settings, part)));
        try {
            return Optional.of(form.create(required));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    /** Adds a switch to each entry that is off. */
    private static Node switched(SettingsForm form, RecordComponent part, Record settings, Node node) {
        if (!part.isAnnotationPresent(Switchable.class)) {
            return node;
        }
        Map<String, Node> all = new LinkedHashMap<>(((Node.Mapping) node).values());
        for (Object name : (Set<?>) SettingsForm.get(settings, form.switchOf(part))) {
            Map<String, Node> one = new LinkedHashMap<>(((Node.Mapping) all.get(name)).values());
            one.put(Switchable.ENABLED, scalar(Boolean.toString(false)));
            all.put((String) name, mapping(one));
        }
        return mapping(all);
    }

    private Node node(Object value, Type type, Quantity quantity, String path) {
        if (value instanceof Node ready) {
            return ready;
        }
        if (value instanceof Optional<?> optional) {
            Object present = optional.orElseThrow(() -> refused(path, "a missing value"));
            return node(present, inner(type, 0), quantity, path);
        }
        if (value instanceof List<?> list) {
            List<Node> items = new ArrayList<>();
            for (Object item : list) {
                items.add(node(item, inner(type, 0), quantity, path + "." + items.size()));
            }
            return Node.Sequence.of(items, NOWHERE);
        }
        if (value instanceof Map<?, ?> map) {
            Map<String, Node> values = new LinkedHashMap<>();
            map.forEach(
                    (key, item) -> values.put((String) key, node(item, inner(type, 1), quantity, path + "." + key)));
            return mapping(values);
        }
        Class<?> plain = (Class<?>) (type instanceof ParameterizedType several ? several.getRawType() : type);
        // An enumeration whose constants have bodies counts as sealed.
        return kinds.isChoice(plain) && !plain.isEnum()
                ? choice(plain, value, path)
                : single(plain, value, quantity, path);
    }

    private static Type inner(Type type, int index) {
        return ((ParameterizedType) type).getActualTypeArguments()[index];
    }

    private Node.Mapping choice(Class<?> type, Object value, String path) {
        String kind = kinds.of(type).entrySet().stream()
                .filter(entry -> entry.getValue() == value.getClass())
                .map(Map.Entry::getKey)
                .findFirst()
                .orElseThrow(() -> refused(
                        path,
                        nameOf(value) + ", which is not one of the kinds "
                                + String.join(", ", kinds.of(type).keySet()) + ","));
        Map<String, Node> written = new LinkedHashMap<>();
        written.put(KindChooser.KIND, scalar(kind));
        written.putAll(parts((Record) value, path));
        return mapping(written);
    }

    private Node single(Class<?> type, Object value, Quantity quantity, String path) {
        if (value instanceof Record record && type == value.getClass()) {
            return record(record, path);
        }
        if (value instanceof Enum<?> constant) {
            return scalar(Choices.name(constant.name()));
        }
        if (value instanceof Double number && Double.isFinite(number)) {
            return scalar(quantity.exactly(number));
        }
        boolean isText = value instanceof String text && !text.isEmpty();
        if (isText || value instanceof Integer || value instanceof Long || value instanceof Boolean) {
            return scalar(value.toString());
        }
        throw refused(path, nameOf(value));
    }

    /**
     * The settings in the shortest form that a reader understands: numbers in order, the only part that is needed, or
     * all parts by name.
     */
    private Node record(Record settings, String path) {
        SettingsForm form = SettingsForm.of(settings.getClass());
        if (form.isNumbers() && form.type().isAnnotationPresent(InOrder.class)) {
            List<Node> numbers = new ArrayList<>();
            form.parts()
                    .forEach(part -> numbers.add(single(
                            part.getType(),
                            SettingsForm.get(settings, part),
                            Quantity.NUMBER,
                            path + "." + part.getName())));
            return Node.Sequence.of(numbers, NOWHERE);
        }
        Map<String, Node> written = parts(settings, path);
        boolean knownByOnePart = !form.isNumbers()
                && form.required().size() == 1
                && written.size() == 1
                && kinds.named(settings.getClass()).isEmpty()
                && written.get(form.required().get(0)) instanceof Node.Scalar;
        return knownByOnePart ? written.get(form.required().get(0)) : mapping(written);
    }

    /** As shown to the user: the value itself, or its class. */
    private static String nameOf(Object value) {
        if (value instanceof String || value instanceof Number) {
            return "'" + value + "'";
        }
        Class<?> type = value.getClass();
        return type.isHidden() || type.isSynthetic() ? "a function" : type.getName();
    }

    private static InputException refused(String path, String what) {
        return new InputException(path + ": " + what + " cannot be written to a file");
    }

    private static Node scalar(String text) {
        return new Node.Scalar(text, NOWHERE);
    }

    private static Node.Mapping mapping(Map<String, Node> values) {
        Map<String, Mark> keys = new LinkedHashMap<>();
        values.keySet().forEach(key -> keys.put(key, NOWHERE));
        return Node.Mapping.of(values, keys, NOWHERE);
    }
}
