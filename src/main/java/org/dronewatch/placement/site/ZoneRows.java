package org.dronewatch.placement.site;

import java.util.BitSet;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.PlacementProblem;

/**
 * The rows of a protected zone in the scene as it is, all of which count the same. Immutable.
 *
 * @param zone its name; empty for all cells that are in none of the zones with weights
 * @param weight weight of each of its cells
 * @param rows the rows of its cells
 * @param present the fraction of the zone that the scene's own sensors cover; empty if it is not known
 */
record ZoneRows(String zone, double weight, BitSet rows, OptionalDouble present) {
    /** These rows with what the scene's own sensors cover. */
    ZoneRows withPresent(PlacementProblem problem, List<Integer> sensors) {
        return new ZoneRows(zone, weight, rows, OptionalDouble.of(covered(problem, sensors)));
    }

    /** The fraction of its rows that enough of some candidates cover. */
    double covered(PlacementProblem problem, List<Integer> chosen) {
        int fold = problem.conditions().fold();
        int[] counts = new int[rows.length()];
        int covered = 0;
        for (int candidate : chosen) {
            CandidateColumn column = problem.table().column(candidate);
            for (int at = 0; at < column.size() && column.row(at) < counts.length; at++) {
                int row = column.row(at);
                counts[row]++;
                covered += rows.get(row) && counts[row] == fold ? 1 : 0;
            }
        }
        return (double) covered / rows.cardinality();
    }
}
