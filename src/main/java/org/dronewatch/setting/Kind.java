package org.dronewatch.setting;

/**
 * One of several kinds among which a scene may choose: a kind of sensor, of flight, of propagation. A provider
 * implements this interface, has a public constructor without parameters, and is named in its jar's
 * {@code META-INF/services/org.dronewatch.setting.Kind}, where {@link java.util.ServiceLoader} finds it. Files name
 * kinds, never classes: which code runs is decided by the class path alone.
 *
 * @param <T> what it is a kind of
 */
public interface Kind<T> {

    /** What it is a kind of: the interface that is the type of a setting. */
    Class<? super T> type();

    /**
     * What files call it after {@code kind:}; lower-case letters, digits and hyphens, 1 to 64, unique among the kinds
     * of its type.
     */
    String name();

    /** Its settings: a record that implements the type. */
    Class<? extends T> settings();

    /** A one-line description. */
    String summary();

    /**
     * A kind with these four properties.
     *
     * @param type the interface
     * @param name what files call it
     * @param settings a record class
     * @param summary one line
     */
    static <T> Kind<T> of(Class<? super T> type, String name, Class<? extends T> settings, String summary) {
        return new PlainKind<>(type, name, settings, summary);
    }
}
