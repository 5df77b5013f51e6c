package org.dronewatch.sensor;

/** Settings of a sensor that takes pictures. A capability: {@link SensorSettings#as}. */
public interface Imaging {

    /** The number of pixels of a picture, above 0. Java must have memory for all of them. */
    long pixels();
}
