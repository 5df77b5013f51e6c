package org.dronewatch.sensor;

import org.dronewatch.geometry.Position;

/**
 * Settings of a sensor of any kind. Implementations are records, so that a scene file and {@code --set} reach every field.
 *
 * @param <S> the sensor that they make
 */
public interface SensorSettings<S extends Sensor> extends Settings<S> {

    /** Where the sensor is, m. */
    Position position();

    /** How often it looks, Hz, above 0: frames, updates or scans a second. */
    double rate();

    /** The word for its kind in results: {@code camera}. */
    String kind();

    /** Whether it matters to this sensor what the world's surfaces are to sound. */
    default boolean hearsSurfaces() {
        return false;
    }
}
