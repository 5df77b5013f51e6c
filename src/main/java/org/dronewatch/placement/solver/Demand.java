package org.dronewatch.placement.solver;

/**
 * A number of some candidates that must be chosen.
 *
 * @param candidates ascending
 * @param need 1 or more
 */
record Demand(int[] candidates, int need) {}
