package org.dronewatch.sensor;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.world.World;

/**
 * Settings of a sensor of any kind. Implementations are records, so that a scene file and {@code --set} reach every field.
 *
 * @param <S> the sensor that they create
 */
public interface SensorSettings<S extends Sensor> extends Settings<S> {

    /** Where the sensor is, m. */
    Position position();

    /** Its field of view, for pictures; none unless a kind of sensor has one. */
    default Optional<Outline> outline() {
        return Optional.empty();
    }

    /** How often it looks, Hz, above 0: frames, updates or scans per second. */
    double rate();

    /** The word for its kind in results: {@code camera}. */
    String kind();

    /** What the values of its observations mean, in words for a plot: {@code sound level}. */
    default String measures() {
        return "value";
    }

    /**
     * Speed of the signal from the drone to the sensor, m/s; infinite if it arrives at once.
     *
     * @param world the site, whose air may matter
     */
    default double signalSpeed(World world) {
        return Double.POSITIVE_INFINITY;
    }

    /** The positioner that turns it; none unless a kind of sensor has one. */
    default Optional<PositionerSettings> positioner() {
        return Optional.empty();
    }

    /** Whether it measures the direction of what it detects: only then can it cue others. */
    default boolean tellsDirection() {
        return false;
    }

    /** The positioner of a sensor that has one, at the start of a run; none for a sensor on a fixed mount. */
    default Optional<Positioner> createPositioner() {
        return Optional.empty();
    }

    /**
     * Where its positioner points once it has turned to a position; empty for a sensor on a fixed mount.
     *
     * @param place position, m
     */
    default Optional<Pointing> turnedTo(Position place) {
        return Optional.empty();
    }

    /**
     * These settings as its positioner points the sensor; unchanged for a sensor on a fixed mount.
     *
     * @param pointing direction and field of view
     */
    default SensorSettings<S> pointed(Pointing pointing) {
        return this;
    }

    /**
     * The number of pixels of its picture; none unless a kind of sensor takes pictures. Java must have memory for all
     * of them.
     */
    default long pixels() {
        return 0;
    }

    /** The words for a drone whose signal is insufficient, such as {@code too quiet}. */
    default String weakness() {
        return "too weak";
    }

    /** What the model of this sensor leaves out, in sentences for a report. */
    default List<String> leavesOut() {
        return List.of();
    }

    /**
     * Conditions of the site that would matter to a real sensor of this kind, but that its model does not take into account;
     * none unless a kind of sensor knows better. A scene that sets one of them gets a warning.
     *
     * @return by condition what to do instead, in words such as {@code set its 'transmission' for such weather}
     */
    default Map<Condition, String> ignoredConditions() {
        return Map.of();
    }

    /** Whether the world's acoustic surfaces matter to this sensor. */
    default boolean hearsSurfaces() {
        return false;
    }
}
