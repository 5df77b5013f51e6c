package org.dronewatch.sensor;

/** Settings of a sensor that points somewhere. A capability: {@link SensorSettings#as}. */
public interface Aimed {

    /** Where it points on its own, without a positioner. */
    Aim aim();

    /**
     * These settings pointing elsewhere, with everything else as it is.
     *
     * @throws IllegalArgumentException when the point at which to aim is less than a millimetre away
     */
    SensorSettings<?> withAim(Aim other);
}
