package org.dronewatch.setting;

/**
 * Settings from which an object is created: an immutable record, changed by its {@code with...} methods. A real sensor
 * is replaced by another by replacing its settings.
 *
 * @param <T> the type of object that they create
 */
public interface Settings<T> {

    /** Creates an object with these settings. */
    T create();
}
