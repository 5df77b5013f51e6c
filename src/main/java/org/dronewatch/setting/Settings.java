package org.dronewatch.setting;

/**
 * Settings from which an object is created: an immutable record, whose {@code with...} methods return changed copies.
 * To simulate another real sensor, replace the settings.
 *
 * @param <T> the type of object that is created
 */
public interface Settings<T> {

    /** Creates an object with these settings. */
    T create();
}
