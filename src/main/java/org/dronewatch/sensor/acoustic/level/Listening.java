package org.dronewatch.sensor.acoustic.level;

/** The criterion for ending a look. Both criteria give the same detections. */
public enum Listening {
    /**
     * A look ends when a ray arrives that reaches the threshold: {@code listen} in the thesis on which this project is
     * based.
     */
    FAST,
    /**
     * A look traces all rays until they end, which gives the highest level and the cumulative energy:
     * {@code listenFully} in the thesis on which this project is based.
     */
    THOROUGH
}
