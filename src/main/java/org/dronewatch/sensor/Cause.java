package org.dronewatch.sensor;

import org.dronewatch.mesh.io.ModelRole;

/** The reason why a sensor does not detect a drone. Where several apply, the first in this order counts. */
public enum Cause {
    /**
     * The line of sight leaves the known ground, at the edge of the terrain or over a hole in it: something may hide
     * the drone there. This cause takes precedence over all others, and over a detection.
     */
    UNKNOWN,
    /** Nearer than the sensor's minimum range, or beyond its maximum range. */
    OUT_OF_RANGE,
    /** Outside the sensor's field of view. */
    OUT_OF_VIEW,
    /** The drone emits nothing that the sensor could receive, or recognise as the signal of a drone. */
    SILENT,
    /** The drone's radial speed is too low for the sensor to separate it from stationary clutter. */
    TOO_SLOW,
    /** The drone's radial speed is higher than the sensor can follow. */
    TOO_FAST,
    /**
     * The drone is hidden, and terrain is the first obstacle on the line of sight. A drone counts as hidden if no part
     * of it is visible, or if it would be detected without the obstacle.
     */
    HIDDEN_BY_TERRAIN,
    /** The drone is hidden by a building, in the sense of {@link #HIDDEN_BY_TERRAIN}. */
    HIDDEN_BY_BUILDING,
    /** The drone is hidden by vegetation, in the sense of {@link #HIDDEN_BY_TERRAIN}. */
    HIDDEN_BY_VEGETATION,
    /** The drone is hidden by any other model, in the sense of {@link #HIDDEN_BY_TERRAIN}. */
    HIDDEN_BY_OTHER,
    /** The drone's signal at the sensor is insufficient: too small, too faint or too quiet. */
    TOO_WEAK,
    /** The drone is detected: there is no miss to explain. */
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
