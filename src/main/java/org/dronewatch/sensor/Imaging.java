package org.dronewatch.sensor;

/** Settings of an imaging sensor. A capability: {@link SensorSettings#as}. */
public interface Imaging {

    /** The number of pixels of an image, above 0. Java must have memory for all of them. */
    long pixels();
}
