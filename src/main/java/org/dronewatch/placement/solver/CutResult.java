package org.dronewatch.placement.solver;

import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;

/**
 * The best layout for the rows, for instance routes, that an oracle has found so far (cutting-plane method).
 *
 * @param problem the problem with all rows that were found
 * @param result the result, whose value is that in the weakest of these rows; the bound holds for all rows, found or
 *     not
 * @param rounds how many layouts the oracle has been asked about, by this search and those before it
 */
public record CutResult(PlacementProblem problem, PlacementResult result, int rounds) {}
