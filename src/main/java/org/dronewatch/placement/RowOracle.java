package org.dronewatch.placement;

import java.util.List;

/** Finds rows of a problem that has too many of them to list, such as the routes past a layout. */
@FunctionalInterface
public interface RowOracle {
    /**
     * Rows in which a layout is weak, among them the weakest that was found.
     *
     * @param chosen indices of the layout's candidates
     * @return for each row, the values of all candidates, 0 or more; may be empty
     * @throws java.util.concurrent.CancellationException when this thread is interrupted
     */
    List<double[]> weakest(List<Integer> chosen);

    /** All rows known so far, including those that {@link #weakest} did not find; may be empty. */
    default List<double[]> known() {
        return List.of();
    }
}
