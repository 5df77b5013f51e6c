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
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.GroundPoint;

/** Makes a settings record with nothing filled in but what must be, to see what the rest is by default. */
public final class Samples {
    private static final Position SOMEWHERE = new Position(1, 2, 3);

    private Samples() {}

    /** A record; empty when it has no defaults to see. */
    public static Optional<Record> of(Class<?> type) {
        SettingsForm form = SettingsForm.of(type);
        if (form.required().size() == form.parts().size()) {
            return Optional.empty();
        }
        Map<String, Object> needed = new HashMap<>();
        for (String name : form.required()) {
            RecordComponent part = form.part(name).orElseThrow();
            needed.put(name, value(part.getGenericType()));
        }
        return Optional.of(form.create(needed));
    }

    private static Object value(Type type) {
        if (type instanceof ParameterizedType several) {
            if (several.getActualTypeArguments()[0] == GroundPoint.class) {
                // A way needs two places.
                return List.of(new GroundPoint(1, 2), new GroundPoint(3, 4));
            }
            return several.getRawType() == Map.class ? Map.of() : List.of(value(several.getActualTypeArguments()[0]));
        }
        Class<?> plain = (Class<?>) type;
        if (plain == Position.class) {
            return SOMEWHERE;
        }
        if (plain == double.class) {
            return 1.0;
        }
        if (plain == int.class) {
            return 1;
        }
        if (plain == String.class) {
            return "some";
        }
        if (plain.isEnum()) {
            return plain.getEnumConstants()[0];
        }
        if (Choices.isChoice(plain)) {
            return value(Choices.of(plain).values().iterator().next());
        }
        return of(plain).orElseGet(() -> filled(plain));
    }

    private static Record filled(Class<?> type) {
        Map<String, Object> all = new HashMap<>();
        for (RecordComponent part : SettingsForm.of(type).parts()) {
            all.put(part.getName(), value(part.getGenericType()));
        }
        return SettingsForm.of(type).create(all);
    }
}
