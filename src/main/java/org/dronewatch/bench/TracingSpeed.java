package org.dronewatch.bench;

/**
 * The speed at which a set of rays was traced.
 *
 * @param set name of the ray set
 * @param traversal method by which they were traced
 * @param rays number of rays
 * @param hits number of rays that hit
 * @param median millions of rays per second, median of the passes
 * @param slowest the slowest pass
 * @param fastest the fastest pass
 */
public record TracingSpeed(
        String set, String traversal, int rays, int hits, double median, double slowest, double fastest) {}
