package org.dronewatch.setting;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/** Kinds of settings among which one is chosen by its name: a model of propagation, a way to fly. */
public final class Choices {
    private Choices() {}

    /**
     * The kinds of a sealed interface by the names that people write: {@code EnergyModel} is {@code energy-model}. Those that
     * are no records are not for people to write.
     */
    public static Map<String, Class<?>> of(Class<?> sealedType) {
        Map<String, Class<?>> kinds = new LinkedHashMap<>();
        for (Class<?> kind : sealedType.getPermittedSubclasses()) {
            if (kind.isRecord()) {
                kinds.put(name(kind.getSimpleName()), kind);
            }
        }
        return Collections.unmodifiableMap(kinds);
    }

    /** A name of Java as people write it: in small letters with dashes. */
    public static String name(String java) {
        return java.replaceAll("(?<=[a-z0-9])(?=[A-Z])", "-")
                .toLowerCase(Locale.ROOT)
                .replace('_', '-');
    }
}
