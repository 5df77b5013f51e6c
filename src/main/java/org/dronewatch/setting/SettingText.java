package org.dronewatch.setting;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Reads the value of a setting from one line of text, with or without its unit. */
public final class SettingText {
    private SettingText() {}

    /**
     * Reads the value of a component of a settings record.
     *
     * @throws IllegalArgumentException when the text is not a value of the component's type
     */
    public static Object parse(RecordComponent part, String text) {
        return parse(part.getGenericType(), quantity(part), text);
    }

    /** The quantity of a component; a plain number unless annotated. */
    public static Quantity quantity(RecordComponent part) {
        In limits = part.getAnnotation(In.class);
        return limits == null ? Quantity.NUMBER : limits.value();
    }

    /**
     * Reads a value of a type.
     *
     * @param type type of a settings component
     * @param quantity the quantity of a number
     * @throws IllegalArgumentException when the text is not a value of the type
     */
    public static Object parse(Type type, Quantity quantity, String text) {
        if (type instanceof ParameterizedType of) {
            return ofSeveral(of, quantity, text);
        }
        Class<?> plain = (Class<?>) type;
        if (plain == double.class || plain == Double.class) {
            return quantity.parse(text);
        }
        if (plain == int.class || plain == Integer.class) {
            return wholeNumber(quantity, text);
        }
        if (plain == long.class || plain == Long.class) {
            return longNumber(text);
        }
        if (plain == boolean.class || plain == Boolean.class) {
            return yesOrNo(text);
        }
        if (plain == String.class) {
            return text;
        }
        if (plain.isEnum()) {
            return constant(plain, text);
        }
        if (plain.isRecord()) {
            return record(SettingsForm.of(plain), text);
        }
        if (Choices.isChoice(plain)) {
            return choice(plain, text);
        }
        throw several();
    }

    private static IllegalArgumentException several() {
        return new IllegalArgumentException("is not a single value: name one of its parts");
    }

    private static Object ofSeveral(ParameterizedType type, Quantity quantity, String text) {
        Type inner = type.getActualTypeArguments()[0];
        if (type.getRawType() == Optional.class) {
            return Optional.of(parse(inner, quantity, text));
        }
        if (type.getRawType() == List.class && (inner == String.class || inner == Double.class)) {
            return Arrays.stream(text.split(","))
                    .map(part -> parse(inner, quantity, part.strip()))
                    .toList();
        }
        if (type.getRawType() == List.class) {
            throw new IllegalArgumentException(
                    "is a list: give an index, 0 for the first; only a scene file can make it longer or shorter");
        }
        throw several();
    }

    private static int wholeNumber(Quantity quantity, String text) {
        double value = quantity.parse(text);
        if (value != Math.rint(value) || Math.abs(value) > Integer.MAX_VALUE) {
            throw new IllegalArgumentException("'" + text + "' is not a whole number");
        }
        return (int) value;
    }

    private static long longNumber(String text) {
        try {
            // A sweep counts in decimal numbers: 2.0 is a whole number, too.
            return new BigDecimal(text.strip()).longValueExact();
        } catch (ArithmeticException | NumberFormatException e) {
            throw new IllegalArgumentException("'" + text + "' is not a whole number of at most 18 digits", e);
        }
    }

    private static boolean yesOrNo(String text) {
        return switch (text.strip().toLowerCase(Locale.ROOT)) {
            case "true", "yes" -> true;
            case "false", "no" -> false;
            default -> throw new IllegalArgumentException("'" + text + "' is neither true nor false");
        };
    }

    private static Object constant(Class<?> type, String text) {
        Map<String, Object> constants = new LinkedHashMap<>();
        for (Object constant : type.getEnumConstants()) {
            constants.put(Choices.name(((Enum<?>) constant).name()), constant);
        }
        Object found = constants.get(Choices.name(text.strip().toUpperCase(Locale.ROOT)));
        if (found == null) {
            throw new IllegalArgumentException("'" + text + "' is not one of " + constants.keySet());
        }
        return found;
    }

    /** One of several kinds of settings by its name, with the values that it has by default. */
    private static Object choice(Class<?> type, String text) {
        Map<String, ? extends Class<?>> kinds = Choices.of(type);
        String name = text.strip();
        Class<?> chosen = kinds.get(name.toLowerCase(Locale.ROOT));
        if (chosen == null) {
            KindRegistry found = KindRegistry.found();
            String hint = name.startsWith("{")
                    ? "; settings in braces can only be written in the scene file"
                    : found.meant(type, name, kinds.keySet())
                            .map(Spelling::question)
                            .orElseGet(() -> found.otherJar(type));
            throw new IllegalArgumentException("'" + text + "' is not one of " + kinds.keySet() + hint);
        }
        SettingsForm form = SettingsForm.of(chosen);
        if (!form.isCompleteByDefault()) {
            throw new IllegalArgumentException("'" + text.strip() + "' needs " + String.join(", ", form.required())
                    + ", which can only be written in the scene file; the kinds are " + kinds.keySet());
        }
        return form.create(Map.of());
    }

    /** A record of numbers as a list of them; a record with a single required component as that component. */
    private static Object record(SettingsForm form, String text) {
        if (form.isNumbers()) {
            return numbers(
                    form, Arrays.stream(text.split(",", -1)).map(String::strip).toList());
        }
        if (form.required().size() == 1) {
            RecordComponent part = form.part(form.required().get(0)).orElseThrow();
            return form.create(Map.of(part.getName(), parse(part, text)));
        }
        throw several();
    }

    /**
     * Reads a record that consists of numbers only.
     *
     * @param texts one text for each component, or a single one for all if the record is marked with {@link OneForAll}
     * @throws IllegalArgumentException when there are more or fewer texts than components, or when one is not a number
     *     or is outside its limits
     */
    public static Record numbers(SettingsForm form, List<String> texts) {
        if (texts.size() == 1 && form.parts().size() > 1 && form.type().isAnnotationPresent(OneForAll.class)) {
            return numbers(form, Collections.nCopies(form.parts().size(), texts.get(0)));
        }
        if (texts.size() != form.parts().size()) {
            throw new IllegalArgumentException("'" + String.join(", ", texts) + "' has "
                    + Counted.of(texts.size(), "number") + " but must have "
                    + form.parts().size() + ": "
                    + String.join(", ", form.names()));
        }
        Map<String, Object> values = new LinkedHashMap<>();
        List<RecordComponent> parts = new ArrayList<>(form.parts());
        for (int i = 0; i < parts.size(); i++) {
            Object value = parse(parts.get(i), texts.get(i));
            Limits.check(parts.get(i), value);
            values.put(parts.get(i).getName(), value);
        }
        return form.create(values);
    }
}
