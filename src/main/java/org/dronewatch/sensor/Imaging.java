package org.dronewatch.sensor;

/** Settings of an imaging sensor. This is a capability, queried by {@link SensorSettings#as}. */
public interface Imaging {

    /** The number of pixels of an image, above 0. The heap must hold all of them. */
    long pixels();
}
