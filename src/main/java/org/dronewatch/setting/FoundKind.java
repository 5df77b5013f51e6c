package org.dronewatch.setting;

import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.regex.Pattern;

/**
 * A kind with its origin.
 *
 * @param kind the kind
 * @param source path of the jar, or of the directory of classes, that provides the kind
 * @param builtIn whether it belongs to the library
 */
public record FoundKind(Kind<?> kind, String source, boolean builtIn) {
    private static final String BUILT_IN = "built in";
    private static final Pattern NAME = Pattern.compile("[a-z0-9][a-z0-9-]{0,63}");

    /**
     * Checks the kind's declaration.
     *
     * @throws InputException if the declaration is invalid: scene files could not use such a kind
     */
    public FoundKind {
        String place = "kind '" + kind.name() + "' from " + source + ": ";
        if (kind.name() == null || !NAME.matcher(kind.name()).matches()) {
            throw new InputException(place + "its name must be 1 to 64 lower-case letters, digits and hyphens");
        }
        if (kind.type() == null || !kind.type().isInterface() || kind.type().isSealed()) {
            throw new InputException(place + "its type must be a non-sealed interface, not " + kind.type());
        }
        Class<?> settings = kind.settings();
        if (settings == null || !settings.isRecord() || !kind.type().isAssignableFrom(settings)) {
            throw new InputException(place + "its settings must be a record that implements "
                    + kind.type().getSimpleName() + ", not " + settings);
        }
        SettingsForm form = SettingsForm.of(settings);
        if (!form.names().containsAll(form.required())) {
            throw new InputException(place + "its @Defaults name " + String.join(", ", form.required())
                    + ", but its settings are " + String.join(", ", form.names()));
        }
        if (kind.summary() == null || kind.summary().isBlank() || kind.summary().contains("\n")) {
            throw new InputException(place + "its summary must be one line");
        }
        if (kind.synonyms() == null) {
            throw new InputException(place + "its synonyms must be a list, which may be empty");
        }
    }

    /** A kind that some class provides. */
    static FoundKind by(Object provider, Kind<?> kind) {
        String place = placeOf(provider.getClass());
        return new FoundKind(kind, place, isBuiltIn(place));
    }

    /** The origin of a class: the path of its jar or directory of classes. */
    public static String placeOf(Class<?> type) {
        CodeSource code = type.getProtectionDomain().getCodeSource();
        URL place = code == null ? null : code.getLocation();
        if (place == null) {
            return "class " + type.getName();
        }
        try {
            return Path.of(place.toURI()).toString();
        } catch (URISyntaxException | IllegalArgumentException | FileSystemNotFoundException e) {
            return place.toString();
        }
    }

    /** Whether a class belongs to the library. */
    public static boolean isBuiltIn(Class<?> type) {
        return isBuiltIn(placeOf(type));
    }

    private static boolean isBuiltIn(String place) {
        return place.equals(placeOf(Kind.class));
    }

    /** The origin of a class, as text for a list. */
    public static String originOf(Class<?> type) {
        String place = placeOf(type);
        return isBuiltIn(place) ? BUILT_IN : place;
    }

    /** The origin of the kind, as text for a list. */
    public String origin() {
        return builtIn ? BUILT_IN : source;
    }
}
