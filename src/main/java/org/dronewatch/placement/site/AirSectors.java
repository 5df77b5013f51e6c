package org.dronewatch.placement.site;

import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.PlacementProblem;

/** The rows of {@link CoveredCells} by eighths of the compass around the centre of the airspace, and by height. */
final class AirSectors {
    private static final int SECTORS = 8;
    private static final double EIGHTH = 0.25 * Math.PI;

    /** A neighbouring height belongs to what is gained if it gains this fraction of the greatest gain at a height. */
    private static final double ALIKE = 0.5;

    private final FieldGrid grid;

    /** By row: {@code sector * heights + height}. */
    private final int[] parts;

    /** By row. */
    private final double[] weights;

    /** The weight of the rows in each part. */
    private final double[] sizes;

    AirSectors(CoveredCells air) {
        this.grid = air.grid();
        this.parts = air.cells();
        this.weights = air.weights();
        this.sizes = new double[SECTORS * grid.heights().size()];
        for (int row = 0; row < parts.length; row++) {
            int cell = parts[row];
            double east = grid.x(air.column(cell)) - grid.east();
            double north = grid.y(air.row(cell)) - grid.north();
            int sector = (int) Math.floorMod(Math.round(StrictMath.atan2(east, north) / EIGHTH), (long) SECTORS);
            parts[row] = sector * grid.heights().size() + air.height(cell);
            sizes[parts[row]] += weights[row];
        }
    }

    /** The part in which a layout gains most over another; empty if it gains in none. */
    Optional<SectorGain> gain(PlacementProblem problem, List<Integer> before, List<Integer> after) {
        double[] had = covered(problem, before);
        double[] has = covered(problem, after);
        int heights = grid.heights().size();
        int best = -1;
        double most = 0.0;
        for (int sector = 0; sector < SECTORS; sector++) {
            double gained = 0.0;
            for (int height = 0; height < heights; height++) {
                gained += has[sector * heights + height] - had[sector * heights + height];
            }
            best = gained > most ? sector : best;
            most = Math.max(most, gained);
        }
        return best < 0 ? Optional.empty() : Optional.of(gain(best, had, has));
    }

    /** The heights of a sector around the one at which most is gained. */
    private SectorGain gain(int sector, double[] had, double[] has) {
        int first = sector * grid.heights().size();
        int last = first + grid.heights().size() - 1;
        int most = first;
        for (int part = first; part <= last; part++) {
            most = has[part] - had[part] > has[most] - had[most] ? part : most;
        }
        double alike = ALIKE * (has[most] - had[most]);
        int low = most;
        int high = most;
        while (low > first && has[low - 1] - had[low - 1] >= alike) {
            low--;
        }
        while (high < last && has[high + 1] - had[high + 1] >= alike) {
            high++;
        }
        double all = 0.0;
        double before = 0.0;
        double after = 0.0;
        for (int part = low; part <= high; part++) {
            all += sizes[part];
            before += had[part];
            after += has[part];
        }
        return new SectorGain(
                sector * EIGHTH,
                grid.heights().get(low - first),
                grid.heights().get(high - first),
                before / all,
                after / all);
    }

    /** By part: the weight of the rows that enough of the chosen candidates cover. */
    private double[] covered(PlacementProblem problem, List<Integer> chosen) {
        int[] counts = new int[parts.length];
        double[] covered = new double[sizes.length];
        for (int candidate : chosen) {
            CandidateColumn column = problem.table().column(candidate);
            for (int at = 0; at < column.size(); at++) {
                int row = column.row(at);
                counts[row]++;
                covered[parts[row]] += counts[row] == problem.conditions().fold() ? weights[row] : 0.0;
            }
        }
        return covered;
    }
}
