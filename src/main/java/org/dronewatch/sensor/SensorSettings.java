package org.dronewatch.sensor;

import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Settings;
import org.dronewatch.world.World;

/**
 * Settings of a sensor of any kind, with the properties that all sensors share. Implementations are records, so that a
 * scene file and {@code --set} reach every field. Properties that only some sensors have are capabilities, interfaces
 * that the record implements as well, such as {@link Aimed}, {@link Mounted}, {@link Outlined}, {@link Imaging},
 * {@link DirectionFinding} and {@link SoundTracing}. Obtain one with {@link #as}.
 *
 * @param <S> the type of sensor that these settings create
 */
public interface SensorSettings<S extends Sensor> extends Settings<S> {

    /** The position of the sensor, m. */
    Position position();

    /**
     * These settings at another position, with everything else unchanged: a sensor that is aimed at a point stays aimed
     * at it.
     *
     * @param other position, m
     * @throws IllegalArgumentException if a setting is out of range there, such as the distance to the point at which
     *     it is aimed
     */
    SensorSettings<S> withPosition(Position other);

    /** The rate of the sensor's looks, Hz, above 0: frames, updates or scans per second. */
    double rate();

    /** The name of this kind of sensor in results, such as {@code camera}. */
    String kind();

    /** Whether chance decides anew in each look, as it does unless overridden, or once per encounter. */
    default Chance chance() {
        return Chance.PER_LOOK;
    }

    /** Warnings about settings that are valid, but implausible: one line each; a scene prints them. */
    default List<String> advice() {
        return List.of();
    }

    /** The texts for reports about this kind of sensor. */
    default SensorDescription description() {
        return SensorDescription.measuring("value");
    }

    /**
     * Speed of the signal from the drone to the sensor, m/s; infinite if it arrives at once.
     *
     * @param world the site, whose air may matter
     */
    default double signalSpeed(World world) {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * These settings as a capability of the sensor; empty if it does not have that capability. A record whose
     * capabilities depend on its components overrides this.
     *
     * @param capability interface of the capability, such as {@code Mounted.class}
     */
    default <C> Optional<C> as(Class<C> capability) {
        return capability.isInstance(this) ? Optional.of(capability.cast(this)) : Optional.empty();
    }
}
