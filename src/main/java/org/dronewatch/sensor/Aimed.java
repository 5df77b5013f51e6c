package org.dronewatch.sensor;

/** Settings of a sensor that can be aimed. This is a capability, queried by {@link SensorSettings#as}. */
public interface Aimed {

    /** The aim of the sensor, in effect when no positioner turns it. */
    Aim aim();

    /** Whether it matters where the sensor points; false if it covers all horizontal directions equally. */
    default boolean isDirectional() {
        return true;
    }

    /**
     * These settings with another aim, and everything else unchanged.
     *
     * @throws IllegalArgumentException when the point at which to aim is less than a millimetre away
     */
    SensorSettings<?> withAim(Aim other);
}
