package org.dronewatch.sensor;

import java.util.Optional;
import org.dronewatch.positioner.Pointing;

/**
 * Settings of a sensor whose field of view has a shape that can be drawn. This is a capability, queried by {@link
 * SensorSettings#as}.
 */
public interface Outlined {

    /** The shape of the field of view for the aim in the sensor's settings. */
    Outline outline();

    /** The shape of any sensor's field of view for the aim in its settings; empty for a sensor that has none. */
    static Optional<Outline> outline(SensorSettings<?> sensor) {
        return sensor.as(Outlined.class).map(Outlined::outline);
    }

    /**
     * The field of view of any sensor, outside which it detects nothing; empty for a sensor without one. A
     * {@linkplain Outline.Ball sphere} around a microphone is not a field of view: the microphone also hears drones
     * outside it.
     *
     * @param pointing where a positioner points the sensor; empty for the aim in its settings
     */
    static Optional<Outline> fieldOfView(SensorSettings<?> sensor, Optional<Pointing> pointing) {
        return outline(Mounted.pointed(sensor, pointing)).filter(shape -> !(shape instanceof Outline.Ball));
    }
}
