package org.dronewatch.sensor.acoustic.level;

/** Which rays of a look are traced. */
enum TracedRays {
    /** All of them. */
    ALL,
    /** Those up to the first that is loud enough. */
    UNTIL_DETECTED,
    /**
     * Those up to the first that is loud enough, without those from which no ray can be loud enough: see {@link
     * DecisiveRays}. The look detects with the same probability as with all rays, but from other random numbers, and
     * its levels below that of detection may be too low.
     */
    DECISIVE
}
