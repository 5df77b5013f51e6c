package org.dronewatch.sensor.acoustic.level;

/** The criterion for ending a look. Both criteria give the same detections. */
public enum Listening {
    /** Ends when a ray arrives that is loud enough: {@code listen} in the thesis on which this project is based. */
    FAST,
    /**
     * Ends when all rays are too quiet, which gives the highest level and the cumulative energy: {@code listenFully} in
     * the thesis on which this project is based.
     */
    THOROUGH
}
