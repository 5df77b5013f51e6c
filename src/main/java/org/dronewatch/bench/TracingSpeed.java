package org.dronewatch.bench;

/**
 * How fast a set of rays was traced.
 *
 * @param set name of the ray set
 * @param traversal how they were traced
 * @param rays how many rays
 * @param hits how many of them hit
 * @param median millions of rays per second, median of the passes
 * @param slowest the slowest pass
 * @param fastest the fastest pass
 */
public record TracingSpeed(
        String set, String traversal, int rays, int hits, double median, double slowest, double fastest) {}
