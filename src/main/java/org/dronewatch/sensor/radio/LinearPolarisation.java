package org.dronewatch.sensor.radio;

/** The polarisation of a wave whose electric field stays in a fixed direction. */
public enum LinearPolarisation {
    /** Horizontal electric field. */
    HORIZONTAL,
    /** Vertical electric field, as from a vertical rod antenna. */
    VERTICAL
}
