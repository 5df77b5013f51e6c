package org.dronewatch.sensor;

/** Settings of a sensor that can be aimed. This is a capability, queried by {@link SensorSettings#as}. */
public interface Aimed {

    /** Its aim, in effect when no positioner turns it. */
    Aim aim();

    /** Whether it matters where it is turned: not if it is the same in all horizontal directions. */
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
