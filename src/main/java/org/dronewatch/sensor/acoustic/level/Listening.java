package org.dronewatch.sensor.acoustic.level;

/** How long the rays of a look are traced. Both detect the same. */
public enum Listening {
    /** Until a ray arrives that is loud enough: the thesis's {@code listen}. */
    FAST,
    /**
     * Until all rays are too quiet, which gives the highest level and the cumulative energy: the thesis's
     * {@code listenFully}.
     */
    THOROUGH
}
