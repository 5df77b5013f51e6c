package org.dronewatch.sensor.optics;

/** The dimension of the image that a field of view spans. */
public enum FieldOfView {
    /** From the bottom edge to the top edge, as in OpenGL's perspective. */
    VERTICAL,
    /** From the left edge to the right edge, as in most data sheets. */
    HORIZONTAL
}
