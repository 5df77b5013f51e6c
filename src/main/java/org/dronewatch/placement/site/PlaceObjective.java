package org.dronewatch.placement.site;

/** What a placement file makes best. */
public enum PlaceObjective {
    /** The fraction of the air in which at least one sensor covers the drone. */
    COVERAGE
}
