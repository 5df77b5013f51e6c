package org.dronewatch.sensor;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.positioner.PositionerSettings;

/**
 * Settings of a sensor that may be mounted on a positioner; one on a fixed mount has none. This is a capability,
 * queried by {@link SensorSettings#as}.
 */
public interface Mounted {

    /** The positioner that turns the sensor; empty for a sensor on a fixed mount. */
    Optional<PositionerSettings> positioner();

    /** The sensor's positioner at the start of a run; empty for a sensor on a fixed mount. */
    Optional<Positioner> createPositioner();

    /**
     * The pointing of the sensor's positioner once it has turned to a position; empty for a sensor on a fixed mount.
     *
     * @param target position, m
     */
    Optional<Pointing> turnedTo(Position target);

    /**
     * The settings of this sensor on a fixed mount, with the given pointing of its positioner.
     *
     * @param pointing direction and field of view
     */
    SensorSettings<?> pointed(Pointing pointing);

    /** The positioner of any sensor; empty for one on a fixed mount. */
    static Optional<PositionerSettings> positioner(SensorSettings<?> sensor) {
        return sensor.as(Mounted.class).flatMap(mounted -> mounted.positioner());
    }

    /**
     * The pointing of any sensor's positioner once it has turned to a position; empty for one on a fixed mount.
     *
     * @param target position, m
     */
    static Optional<Pointing> turnedTo(SensorSettings<?> sensor, Position target) {
        return sensor.as(Mounted.class).flatMap(mounted -> mounted.turnedTo(target));
    }

    /**
     * The settings of any sensor, pointed as its positioner points it.
     *
     * @param pointing where the positioner points; empty for the aim in the sensor's settings
     * @return the settings as they are if {@code pointing} is empty or no positioner can turn the sensor
     */
    static SensorSettings<?> pointed(SensorSettings<?> sensor, Optional<Pointing> pointing) {
        return pointing.<SensorSettings<?>>flatMap(
                        to -> sensor.as(Mounted.class).map(mounted -> mounted.pointed(to)))
                .orElse(sensor);
    }
}
