package org.dronewatch.sensor;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.World;

/**
 * Settings of a sensor of any kind. Implementations are records, so that a scene file and {@code --set} reach every field.
 *
 * @param <S> the sensor that they make
 */
public interface SensorSettings<S extends Sensor> extends Settings<S> {

    /** Where the sensor is, m. */
    Position position();

    /** The space that it looks into, for pictures; none unless a kind of sensor has one. */
    default Optional<Outline> outline() {
        return Optional.empty();
    }

    /** How often it looks, Hz, above 0: frames, updates or scans a second. */
    double rate();

    /** The word for its kind in results: {@code camera}. */
    String kind();

    /**
     * How fast what it senses comes from the drone to it, m/s; infinity unless it takes its time.
     *
     * @param world the site, of which the air may matter
     */
    default double signalSpeed(World world) {
        return Double.POSITIVE_INFINITY;
    }

    /** Whether it matters to this sensor what the world's surfaces are to sound. */
    default boolean hearsSurfaces() {
        return false;
    }
}
