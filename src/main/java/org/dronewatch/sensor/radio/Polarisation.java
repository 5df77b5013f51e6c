package org.dronewatch.sensor.radio;

/** The polarisation of a wave that the ground reflects. */
public enum Polarisation {
    /** Horizontal electric field. */
    HORIZONTAL,
    /** Vertical electric field, as from a vertical rod antenna. */
    VERTICAL
}
