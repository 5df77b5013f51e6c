package org.dronewatch.placement.plan;

/** Which of the warning times of all flights counts. */
public enum WarningMeasure {
    /** The shortest warning time. */
    WORST,
    /** The mean of all warning times. */
    MEAN
}
