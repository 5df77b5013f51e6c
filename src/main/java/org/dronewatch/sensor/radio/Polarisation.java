package org.dronewatch.sensor.radio;

/** Polarisation of a wave that the ground reflects. */
public enum Polarisation {
    /** The electric field is level. */
    HORIZONTAL,
    /** The electric field is upright, as of an upright rod. */
    VERTICAL
}
