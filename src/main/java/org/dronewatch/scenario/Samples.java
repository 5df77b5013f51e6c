package org.dronewatch.scenario;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.In;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.file.Node;
import org.dronewatch.world.GroundPoint;

/** Instantiates a settings record with only its required components filled in, to find the defaults of the others. */
public final class Samples {
    private static final Position SOMEWHERE = new Position(1, 2, 3);
    /** Depth to which nested lists are filled: those of records that contain themselves would never end. */
    private static final int DEEPEST = 8;

    private Samples() {}

    /**
     * A record of a type; empty if the type has no defaults, or rejects the values tried for its required components.
     */
    public static Optional<Record> of(Class<?> type) {
        return of(type, 0);
    }

    private static Optional<Record> of(Class<?> type, int depth) {
        SettingsForm form = SettingsForm.of(type);
        if (form.required().size() == form.parts().size()) {
            return Optional.empty();
        }
        try {
            return Optional.of(form.create(values(form, form.required(), depth)));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private static Map<String, Object> values(SettingsForm form, List<String> names, int depth) {
        Map<String, Object> values = new HashMap<>();
        for (String name : names) {
            RecordComponent part = form.part(name).orElseThrow();
            values.put(name, value(part.getGenericType(), part.getAnnotation(In.class), depth));
        }
        return values;
    }

    private static Object value(Type type, In limits, int depth) {
        if (type instanceof ParameterizedType several) {
            return several((Class<?>) several.getRawType(), several.getActualTypeArguments(), limits, depth);
        }
        Class<?> plain = (Class<?>) type;
        if (plain == Position.class) {
            return SOMEWHERE;
        }
        if (plain == Node.Mapping.class) {
            return Node.Mapping.ofNodes("sample", Map.of());
        }
        if (plain == double.class || plain == Double.class) {
            return within(limits);
        }
        if (plain == int.class) {
            return (int) within(limits);
        }
        if (plain == long.class) {
            return (long) within(limits);
        }
        if (plain == boolean.class) {
            return false;
        }
        if (plain == String.class) {
            return "some";
        }
        if (plain.isEnum()) {
            return plain.getEnumConstants()[0];
        }
        if (Choices.isChoice(plain)) {
            return value(Choices.of(plain).values().iterator().next(), null, depth);
        }
        SettingsForm form = SettingsForm.of(plain);
        return of(plain, depth).orElseGet(() -> form.create(values(form, form.names(), depth)));
    }

    private static Object several(Class<?> raw, Type[] inner, In limits, int depth) {
        if (raw == Optional.class) {
            return Optional.empty();
        }
        if (raw == Map.class) {
            return Map.of();
        }
        if (raw != List.class) {
            return value(raw, limits, depth);
        }
        if (depth >= DEEPEST) {
            return List.of();
        }
        // A path needs two points.
        return inner[0] == GroundPoint.class
                ? List.of(new GroundPoint(1, 2), new GroundPoint(3, 4))
                : List.of(value(inner[0], limits, depth + 1));
    }

    /** The value 1 if it is allowed, otherwise about the middle of the allowed range. */
    private static double within(In limits) {
        if (limits == null) {
            return 1.0;
        }
        double low = Math.max(limits.from(), limits.above());
        double high = Math.min(limits.to(), limits.below());
        if (low < 1.0 && 1.0 < high) {
            return 1.0;
        }
        if (Double.isInfinite(low)) {
            return high - 1.0;
        }
        return Double.isInfinite(high) ? low + 1.0 : 0.5 * (low + high);
    }
}
