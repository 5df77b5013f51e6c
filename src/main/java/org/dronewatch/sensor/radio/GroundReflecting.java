package org.dronewatch.sensor.radio;

import java.util.Optional;

/** A sensor whose radio waves may be reflected by the ground. */
public interface GroundReflecting {
    /** The ground that reflects them; empty if their reflection is left out. */
    Optional<ReflectingGround> groundReflection();
}
