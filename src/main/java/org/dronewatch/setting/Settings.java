package org.dronewatch.setting;

/**
 * Everything needed to create an object: an immutable record, changed by its {@code with...} methods. One real sensor
 * is swapped for another by swapping its settings.
 *
 * @param <T> what the settings create
 */
public interface Settings<T> {

    /** Creates an object with these settings. */
    T create();
}
