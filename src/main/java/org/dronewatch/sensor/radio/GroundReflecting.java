package org.dronewatch.sensor.radio;

import java.util.Optional;

/** A sensor whose radio waves may be reflected by the ground. */
public interface GroundReflecting {
    /** The ground that reflects the sensor's radio waves; empty if their reflection is not modelled. */
    Optional<ReflectingGround> groundReflection();
}
