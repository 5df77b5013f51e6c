package org.dronewatch.setting;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/** Kinds of settings that files choose by name, such as a propagation model or a flight. */
public final class Choices {
    private Choices() {}

    /**
     * The kinds of an interface by the names used in scene files: for a sealed interface, the kinds that it permits,
     * with names such as {@code on-the-run} for {@code OnTheRun}; for any other interface, the kinds on the class path.
     * Kinds that are not records cannot be written in files.
     *
     * @throws InputException when a kind on the class path is invalid
     */
    public static Map<String, Class<?>> of(Class<?> type) {
        if (!type.isSealed()) {
            return KindRegistry.found().of(type);
        }
        Map<String, Class<?>> kinds = new LinkedHashMap<>();
        for (Class<?> kind : type.getPermittedSubclasses()) {
            if (kind.isRecord()) {
                kinds.put(name(kind.getSimpleName()), kind);
            }
        }
        return Collections.unmodifiableMap(kinds);
    }

    /** Whether a type has kinds among which settings choose. */
    public static boolean isChoice(Class<?> type) {
        return type.isSealed() || type.isInterface() && KindRegistry.found().knows(type);
    }

    /** The name used in files for the kind of some settings. */
    public static String nameOf(Class<?> settings) {
        return KindRegistry.found().kindOf(settings).map(Kind::name).orElseGet(() -> name(settings.getSimpleName()));
    }

    /** Converts a Java name to the form used in files: lower case with hyphens. */
    public static String name(String java) {
        return java.replaceAll("(?<=[a-z0-9])(?=[A-Z])", "-")
                .toLowerCase(Locale.ROOT)
                .replace('_', '-');
    }
}
