package org.dronewatch.sensor;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.positioner.PositionerSettings;
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

    /** What the values of its observations are, in words for a plot: {@code sound level}. */
    default String measures() {
        return "value";
    }

    /**
     * How fast what it senses comes from the drone to it, m/s; infinity unless it takes its time.
     *
     * @param world the site, of which the air may matter
     */
    default double signalSpeed(World world) {
        return Double.POSITIVE_INFINITY;
    }

    /** The mount that turns it; none unless a kind of sensor has one. */
    default Optional<PositionerSettings> positioner() {
        return Optional.empty();
    }

    /** Whether what it detects tells from which direction: only then can others be pointed by it. */
    default boolean tellsDirection() {
        return false;
    }

    /** A mount for a sensor with one, at the start of a run; none for a sensor that stands still. */
    default Optional<Positioner> createPositioner() {
        return Optional.empty();
    }

    /**
     * Where its mount points once it has turned to a place; empty for a sensor that stands still.
     *
     * @param place m
     */
    default Optional<Pointing> turnedTo(Position place) {
        return Optional.empty();
    }

    /**
     * These settings as a mount points the sensor; the same for a sensor that stands still.
     *
     * @param pointing where, and with which field of view
     */
    default SensorSettings<S> pointed(Pointing pointing) {
        return this;
    }

    /**
     * Why this sensor cannot notice a drone even where it looks, in words such as {@code too slow for it}; empty when it could.
     *
     * @param drone as it flies now
     */
    default Optional<String> blindTo(Drone drone) {
        return Optional.empty();
    }

    /** How many pixels its picture has; none unless a kind of sensor takes pictures. Java must have memory for all of them. */
    default long pixels() {
        return 0;
    }

    /** What is said of a drone of which it has too little, such as {@code too quiet}. */
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

    /** Whether it matters to this sensor what the world's surfaces are to sound. */
    default boolean hearsSurfaces() {
        return false;
    }
}
