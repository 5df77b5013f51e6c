package org.dronewatch.sensor.radio;

import java.util.Optional;

/**
 * Settings of a sensor whose radio waves may be reflected by the ground. This is a capability, queried by
 * {@link org.dronewatch.sensor.SensorSettings#as}.
 */
public interface GroundReflecting {
    /** The ground that reflects the sensor's radio waves; empty if their reflection is not modelled. */
    Optional<ReflectingGround> groundReflection();
}
