package org.dronewatch.analysis.survey;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.sensor.Cause;

/**
 * A gap in the coverage at one height: cells that no sensor covers, connected along their edges.
 *
 * @param cells number of cells in the gap
 * @param area area of the gap, m2
 * @param x east coordinate of the centre of the gap's innermost cell, m: the cell that is farthest from everything
 *     outside the gap; in a tie, the first from the north-west
 * @param y north coordinate of the same cell, m
 * @param causes the number of cells for each dominant cause, in the order of {@link Cause}
 * @param cause the most frequent dominant cause in the gap; in a tie, the one nearest to a detection
 * @param touchesRim whether the gap reaches the edge of the grid or of its area, so that it may continue outside
 */
public record Gap(
        int cells, double area, double x, double y, Map<Cause, Integer> causes, Cause cause, boolean touchesRim) {
    /** Copies the map: later changes by the caller have no effect. */
    public Gap {
        causes = Collections.unmodifiableMap(new LinkedHashMap<>(causes));
    }

    /**
     * A gap.
     *
     * @param causes the number of cells for each dominant cause, in the order of {@link Cause}
     * @param cellArea area of a cell, m2
     */
    static Gap of(Map<Cause, Integer> causes, double cellArea, double x, double y, boolean touchesRim) {
        int cells = 0;
        int most = 0;
        Cause cause = Cause.UNKNOWN;
        for (Map.Entry<Cause, Integer> one : causes.entrySet()) {
            cells += one.getValue();
            if (one.getValue() >= most) {
                most = one.getValue();
                cause = one.getKey();
            }
        }
        return new Gap(cells, cells * cellArea, x, y, causes, cause, touchesRim);
    }

    /**
     * The largest gap at a height, given by its number; in a tie, the first from the north-west; empty if there is
     * none.
     */
    public static Optional<Gap> largest(FieldCoverage coverage, int height) {
        return GapMap.of(coverage, height).gaps().stream().findFirst();
    }
}
