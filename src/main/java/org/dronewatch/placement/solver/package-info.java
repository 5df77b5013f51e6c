/** Finds the best choice among candidates, with a bound: greedy starts, swaps, Lagrangian bounds, branch and bound. */
package org.dronewatch.placement.solver;
