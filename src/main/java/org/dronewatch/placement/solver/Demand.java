package org.dronewatch.placement.solver;

/**
 * So many of some candidates must be chosen.
 *
 * @param candidates ascending
 * @param need 1 or more
 */
record Demand(int[] candidates, int need) {}
