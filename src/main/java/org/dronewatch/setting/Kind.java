package org.dronewatch.setting;

import java.util.List;

/**
 * A kind of settings that scenes can choose by name, such as a kind of sensor, of flight or of propagation. A provider
 * implements this interface, has a public constructor without parameters, and is named in its jar's {@code
 * META-INF/services/org.dronewatch.setting.Kind}, where {@link java.util.ServiceLoader} finds it. Files name kinds,
 * never classes, so the class path alone decides which code can run.
 *
 * @param <T> the interface of which this is a kind
 */
public interface Kind<T> {

    /** The interface of which this is a kind; it is the type of a setting. */
    Class<? super T> type();

    /**
     * The name of the kind in files, after {@code kind:}; lower-case letters, digits and hyphens, 1 to 64, unique among
     * the kinds of its type.
     */
    String name();

    /** The settings of the kind: a record that implements the type. */
    Class<? extends T> settings();

    /** A one-line description. */
    String summary();

    /**
     * Other words for the kind, in lower case, that somebody may write instead of its name. Files do not accept them,
     * but a message then suggests the name.
     */
    default List<String> synonyms() {
        return List.of();
    }

    /**
     * A kind with these four properties.
     *
     * @param type the interface
     * @param name its name in files
     * @param settings a record class
     * @param summary a description of one line
     */
    static <T> Kind<T> of(Class<? super T> type, String name, Class<? extends T> settings, String summary) {
        return new PlainKind<>(type, name, settings, summary, List.of());
    }

    /** This kind with other {@link #synonyms}, which replace any that it has. */
    default Kind<T> withSynonyms(String... words) {
        return new PlainKind<>(type(), name(), settings(), summary(), List.of(words));
    }
}
