package org.dronewatch.sensor;

/**
 * Everything one needs to know to make a thing: an immutable record, changed by its {@code with...} methods. One real
 * sensor is swapped for another by swapping its settings.
 *
 * @param <T> what the settings make
 */
public interface Settings<T> {

    /** A new thing of these settings. */
    T create();
}
