package org.dronewatch.scene;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Quantity;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.OctaveBands;

/** Reads the value of one settings component from text. */
final class SettingValue {
    private static final double MAX_INT = Integer.MAX_VALUE;
    private static final String DEFAULT = "DEFAULT";

    private SettingValue() {}

    /**
     * The value for a component.
     *
     * @throws IllegalArgumentException when the text is no value of the component's type
     */
    static Object parse(RecordComponent component, String text) {
        Class<?> type = component.getType();
        In annotation = component.getAnnotation(In.class);
        Quantity quantity = annotation == null ? Quantity.NUMBER : annotation.value();
        if (type == double.class) {
            return quantity.parse(text);
        }
        if (type == int.class) {
            return wholeNumber(quantity, text);
        }
        if (type == long.class) {
            return longNumber(text);
        }
        if (type == String.class) {
            return text;
        }
        if (type.isEnum()) {
            return constant(type, text);
        }
        if (type == Position.class) {
            return position(text);
        }
        if (type == BandLevels.class) {
            return spectrum(text);
        }
        if (type.isSealed()) {
            return choice(type, text);
        }
        if (component.getGenericType().getTypeName().equals("java.util.List<java.lang.String>")) {
            return Arrays.stream(text.split(",")).map(String::strip).toList();
        }
        throw new IllegalArgumentException("is not a single value: name one of its parts");
    }

    private static int wholeNumber(Quantity quantity, String text) {
        double value = quantity.parse(text);
        if (value != Math.rint(value) || Math.abs(value) > MAX_INT) {
            throw new IllegalArgumentException("'" + text + "' is not a whole number");
        }
        return (int) value;
    }

    private static long longNumber(String text) {
        try {
            return Long.parseLong(text.strip());
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + text + "' is not a whole number of at most 18 digits", e);
        }
    }

    private static Object constant(Class<?> type, String text) {
        String wanted = text.strip().toUpperCase(Locale.ROOT).replace('-', '_');
        List<?> constants = Arrays.asList(type.getEnumConstants());
        return constants.stream()
                .filter(constant -> constant.toString().equals(wanted))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("'" + text + "' is none of "
                        + constants.toString().toLowerCase(Locale.ROOT).replace('_', '-')));
    }

    /** One of several kinds of settings by its name, with the values that it has by default. */
    private static Object choice(Class<?> type, String text) {
        Map<String, Class<?>> kinds = new TreeMap<>();
        for (Class<?> kind : type.getPermittedSubclasses()) {
            if (Arrays.stream(kind.getFields())
                    .anyMatch(field -> field.getName().equals(DEFAULT))) {
                kinds.put(kebab(kind.getSimpleName()), kind);
            }
        }
        Class<?> chosen = kinds.get(text.strip().toLowerCase(Locale.ROOT));
        if (kinds.isEmpty()) {
            throw new IllegalArgumentException("is not a single value: name one of its parts");
        }
        if (chosen == null) {
            throw new IllegalArgumentException("'" + text + "' is none of " + kinds.keySet());
        }
        try {
            return chosen.getField(DEFAULT).get(null);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("settings " + chosen.getName() + " have no default", e);
        }
    }

    private static String kebab(String name) {
        return name.replaceAll("(?<=[a-z0-9])(?=[A-Z])", "-").toLowerCase(Locale.ROOT);
    }

    private static BandLevels spectrum(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length != OctaveBands.COUNT) {
            throw new IllegalArgumentException("'" + text + "' is no spectrum: write " + OctaveBands.COUNT
                    + " levels from 63 Hz to 8 kHz as in 40, 38, 35, 32, 30, 27, 23, 18");
        }
        return BandLevels.of(
                Arrays.stream(parts).mapToDouble(Quantity.LEVEL::parse).toArray());
    }

    private static Position position(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length != 3) {
            throw new IllegalArgumentException("'" + text + "' is no position: write east, north, up as in 10, 0, 2.5");
        }
        return new Position(
                Quantity.LENGTH.parse(parts[0]), Quantity.LENGTH.parse(parts[1]), Quantity.LENGTH.parse(parts[2]));
    }
}
