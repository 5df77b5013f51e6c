package org.dronewatch.sensor;

import org.dronewatch.mesh.io.ModelRole;

/** The reason why a sensor does not detect a drone. Where several apply, the first in this order counts. */
public enum Cause {
    /**
     * The line of sight leaves the known ground, at a rim or over a hole of the terrain: something may hide the drone
     * there. It takes precedence over all others, and over a detection.
     */
    UNKNOWN,
    /** Nearer than the sensor's minimum range, or beyond its maximum range. */
    OUT_OF_RANGE,
    /** Outside the sensor's field of view. */
    OUT_OF_VIEW,
    /** It emits nothing that the sensor could receive, or recognise as a drone's. */
    SILENT,
    /** Its radial speed is too low for the sensor to separate it from stationary clutter. */
    TOO_SLOW,
    /** Its radial speed is more than the sensor can follow. */
    TOO_FAST,
    /**
     * Nothing of it is visible, or it would be detected if nothing hid it, and the line of sight hits terrain first.
     */
    HIDDEN_BY_TERRAIN,
    /** The same with a building. */
    HIDDEN_BY_BUILDING,
    /** The same with plants. */
    HIDDEN_BY_VEGETATION,
    /** The same with any other model. */
    HIDDEN_BY_OTHER,
    /** Its signal at the sensor is insufficient: too small, too faint, too quiet. */
    TOO_WEAK,
    /** It is detected: there is nothing to explain. */
    DETECTED;

    /** The cause for a drone that is hidden by a model of a given role. */
    public static Cause hiddenBy(ModelRole role) {
        return switch (role) {
            case TERRAIN -> HIDDEN_BY_TERRAIN;
            case BUILDING -> HIDDEN_BY_BUILDING;
            case VEGETATION -> HIDDEN_BY_VEGETATION;
            case OTHER -> HIDDEN_BY_OTHER;
        };
    }

    /** Whether something hides the drone. */
    public boolean isHidden() {
        return this == HIDDEN_BY_TERRAIN
                || this == HIDDEN_BY_BUILDING
                || this == HIDDEN_BY_VEGETATION
                || this == HIDDEN_BY_OTHER;
    }
}
