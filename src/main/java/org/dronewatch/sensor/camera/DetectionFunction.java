package org.dronewatch.sensor.camera;

/** Decides whether a camera detects a drone: a value from the drone's view, and what it must reach. */
public interface DetectionFunction {

    /** The value that is compared with the threshold. */
    double value(DroneView view);

    /** The value from which on the drone counts as detected. */
    double threshold();

    /** Unit of value and threshold. */
    String unit();
}
