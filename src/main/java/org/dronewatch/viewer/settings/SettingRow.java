package org.dronewatch.viewer.settings;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;

/**
 * One setting in a tree of records, whose value can be written as a line of text.
 *
 * @param path path of the setting in the tree, as in {@code detection.pixels}
 * @param value value of the setting with its unit, as it can be written; {@link #NONE} if it is not set
 * @param allowed the values that it can have, in words; empty if any value is valid
 * @param quantity quantity of a numeric value
 */
public record SettingRow(String path, String value, String allowed, Quantity quantity) {
    /** The value of a setting that is not set. */
    public static final String NONE = "none";

    /** All settings of a record, in the order of its components. */
    public static List<SettingRow> of(Record settings) {
        List<SettingRow> rows = new ArrayList<>();
        addParts("", settings, rows);
        return rows;
    }

    /**
     * The text to be parsed: a number without a unit is given the unit in which the value is shown.
     *
     * @param text what the user has typed
     */
    public String withUnit(String text) {
        boolean isBare = text.strip().matches("[-+]?[.\\d]+([eE][-+]?\\d+)?");
        boolean isShownOtherwise = !quantity.displayUnit().equals(quantity.unit());
        return isBare && isShownOtherwise ? text.strip() + " " + quantity.displayUnit() : text.strip();
    }

    private static void addParts(String path, Record settings, List<SettingRow> rows) {
        for (RecordComponent part : SettingsForm.of(settings.getClass()).parts()) {
            Object value = SettingsForm.get(settings, part);
            add(path + part.getName(), part, value instanceof Optional<?> some ? some.orElse(null) : value, rows);
        }
    }

    private static void add(String path, RecordComponent part, Object value, List<SettingRow> rows) {
        if (value instanceof List<?> list && isOfRecords(list)) {
            for (int i = 0; i < list.size(); i++) {
                addParts(path + "." + i + ".", (Record) list.get(i), rows);
            }
        } else if (value instanceof List<?> list && !isWritable(list)) {
            // Only a scene file can change it.
            return;
        } else if (value instanceof Map<?, ?> map) {
            map.forEach((key, one) -> {
                if (one instanceof Record inside) {
                    addParts(path + "." + key + ".", inside, rows);
                }
            });
        } else if (value instanceof Record inside) {
            if (Choices.isChoice(single(part))) {
                rows.add(row(path, part, Choices.nameOf(inside.getClass())));
            }
            addParts(path + ".", inside, rows);
        } else if (value != null || isSingle(single(part))) {
            rows.add(row(path, part, text(part, value)));
        }
    }

    private static boolean isWritable(List<?> list) {
        return !list.isEmpty() && (list.get(0) instanceof String || list.get(0) instanceof Double);
    }

    private static boolean isOfRecords(List<?> list) {
        return !list.isEmpty() && list.get(0) instanceof Record;
    }

    private static SettingRow row(String path, RecordComponent part, String value) {
        return new SettingRow(path, value, allowed(part), SettingText.quantity(part));
    }

    /** The type of a component, or of what is in it if it is optional. */
    private static Class<?> single(RecordComponent part) {
        if (part.getType() == Optional.class && part.getGenericType() instanceof ParameterizedType type) {
            Type inner = type.getActualTypeArguments()[0];
            return inner instanceof Class<?> plain ? plain : Object.class;
        }
        return part.getType();
    }

    private static boolean isSingle(Class<?> type) {
        return type == String.class || type == Boolean.class || Number.class.isAssignableFrom(type) || type.isEnum();
    }

    private static String text(RecordComponent part, Object value) {
        if (value == null) {
            return NONE;
        }
        if (value instanceof Number number) {
            return part.isAnnotationPresent(In.class)
                    ? SettingText.quantity(part).exactly(number.doubleValue())
                    : number.toString();
        }
        if (value instanceof Enum<?> constant) {
            return Choices.name(constant.name());
        }
        if (value instanceof List<?> list) {
            return list.stream().map(one -> text(part, one)).collect(Collectors.joining(", "));
        }
        return value.toString();
    }

    private static String allowed(RecordComponent part) {
        Class<?> type = single(part);
        if (type == boolean.class || type == Boolean.class) {
            return "true or false";
        }
        if (type.isEnum()) {
            return Arrays.stream(type.getEnumConstants())
                    .map(constant -> Choices.name(((Enum<?>) constant).name()))
                    .collect(Collectors.joining(", "));
        }
        if (Choices.isChoice(type)) {
            return String.join(", ", Choices.of(type).keySet());
        }
        In limits = part.getAnnotation(In.class);
        return limits == null ? "" : Limits.inWords(limits);
    }
}
