package org.dronewatch.sensor;

/**
 * Settings of a sensor that traces sound through the site: the world's acoustic surfaces matter to it, and the sensor
 * may lie on a surface. This is a capability, queried by {@link SensorSettings#as}.
 */
public interface SoundTracing {

    /** Whether the report and the viewer show its rays by default. */
    default boolean drawRays() {
        return false;
    }
}
