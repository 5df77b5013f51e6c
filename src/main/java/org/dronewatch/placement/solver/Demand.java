package org.dronewatch.placement.solver;

/**
 * How many of a set of candidates must be chosen.
 *
 * @param candidates ascending
 * @param need 1 or more
 */
record Demand(int[] candidates, int need) {}
