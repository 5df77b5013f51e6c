package org.dronewatch.sensor.acoustic.level;

/** A choice of the rays of a look that are traced. */
enum TracedRays {
    /** All of them. */
    ALL,
    /** Those up to the first that is loud enough. */
    UNTIL_DETECTED,
    /**
     * The rays up to the first that is loud enough, without those that end at the next surface and cannot be loud
     * enough at the sensor: see {@link DecisiveRays}. The others have the same random numbers, so that the look detects
     * the drone if it does so with {@link #UNTIL_DETECTED}, and by the same ray; levels below that of detection may be
     * too low. The ray budget must not end any ray.
     */
    DECISIVE_OF_LOOK,
    /**
     * The rays up to the first that is loud enough, without those from which no ray can be loud enough: see
     * {@link DecisiveRays}. The look detects the drone with the same probability as with all rays, but by other random
     * numbers, and levels below that of detection may be too low.
     */
    DECISIVE
}
