package org.dronewatch.bench;

/**
 * The speed at which a set of rays was traced.
 *
 * @param set name of the ray set
 * @param traversal method by which the rays were traced
 * @param rays number of rays
 * @param hits number of rays that hit
 * @param median median speed of the passes, millions of rays per second
 * @param slowest speed of the slowest pass, millions of rays per second
 * @param fastest speed of the fastest pass, millions of rays per second
 */
public record TracingSpeed(
        String set, String traversal, int rays, int hits, double median, double slowest, double fastest) {}
