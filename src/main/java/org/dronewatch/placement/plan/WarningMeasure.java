package org.dronewatch.placement.plan;

/** Which of the warnings of all flights counts. */
public enum WarningMeasure {
    /** The shortest warning. */
    WORST,
    /** The mean of all warnings. */
    MEAN
}
