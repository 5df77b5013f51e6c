package org.dronewatch.placement.plan;

/** Which of the warnings of all flights counts. */
public enum WarningMeasure {
    /** The shortest. */
    WORST,
    /** Their mean. */
    MEAN
}
