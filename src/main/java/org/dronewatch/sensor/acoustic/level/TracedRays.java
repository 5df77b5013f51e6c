package org.dronewatch.sensor.acoustic.level;

/** Which rays of a look are traced. */
enum TracedRays {
    /** All of them. */
    ALL,
    /** Those up to the first that is loud enough. */
    UNTIL_DETECTED,
    /**
     * The rays up to the first that is loud enough, without those that end at the next surface and cannot be loud
     * enough at the sensor: see {@link DecisiveRays}. The others have the same random numbers, so that the look detects
     * the drone, and by the same ray, as with {@link #UNTIL_DETECTED}; below the level of detection, its levels may be
     * too low. The ray budget must not end any ray.
     */
    DECISIVE_OF_LOOK,
    /**
     * The rays up to the first that is loud enough, without those from which no ray can be loud enough: see {@link
     * DecisiveRays}. The look detects with the same probability as with all rays, but from other random numbers, and
     * its levels below that of detection may be too low.
     */
    DECISIVE
}
