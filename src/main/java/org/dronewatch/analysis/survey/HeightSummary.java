package org.dronewatch.analysis.survey;

import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.sensor.Cause;

/**
 * The coverage at one height, in numbers of cells.
 *
 * @param height height above the ground, m
 * @param cells number of cells in the area of the grid
 * @param known number of cells that are neither unknown nor inside something solid
 * @param inside number of cells inside something solid
 * @param covered number of known cells that a sensor covers
 * @param volume volume of the air that the covered cells represent, m3; see {@link FieldGrid#depth}
 * @param causes number of known cells by dominant cause, in the order of {@link Cause}
 * @param causesBySensor for each sensor, in the order of the scene: the number of known cells for each cause of that
 *     sensor, on the course that counts in each cell; {@link Cause#DETECTED} where a single look detects the drone
 * @param counts number of known cells by the number of sensors that cover them, from none upwards
 * @param lost by sensor, how many more cells are covered with it than without it: those lost without it, less those
 *     gained, since without the sensor another course may count, on which the other sensors cover more; the number may
 *     therefore be 0 although cells change, or be below 0
 * @param changed by sensor, the number of cells that are covered either with it or without it, but not both
 * @param gap the largest gap; empty if there is none
 */
public record HeightSummary(
        double height,
        int cells,
        int known,
        int inside,
        int covered,
        double volume,
        Map<Cause, Integer> causes,
        Map<String, Map<Cause, Integer>> causesBySensor,
        int[] counts,
        Map<String, Integer> lost,
        Map<String, Integer> changed,
        Optional<Gap> gap) {

    /** The number of unknown cells. */
    public int unknown() {
        return cells - known - inside;
    }

    /**
     * A height of a coverage, given by its number.
     *
     * @param without the coverage without each of the sensors
     */
    static HeightSummary of(FieldCoverage coverage, int height, Map<String, FieldCoverage> without) {
        FieldGrid grid = coverage.field().grid();
        DetectionField field = coverage.field();
        int cells = grid.count((column, row) -> !field.isOutside(height, column, row));
        int known = grid.count((column, row) -> coverage.isKnown(height, column, row));
        int inside = grid.count((column, row) -> field.isInside(height, column, row));
        int covered = grid.count((column, row) -> coverage.isCovered(height, column, row));
        Map<Cause, Integer> causes = new EnumMap<>(Cause.class);
        int[] counts = new int[field.sensors().size() + 1];
        grid.forEachCell((column, row) -> {
            if (coverage.isKnown(height, column, row)) {
                causes.merge(coverage.cause(height, column, row), 1, Integer::sum);
                counts[coverage.count(height, column, row)]++;
            }
        });
        Map<String, Map<Cause, Integer>> causesBySensor = new LinkedHashMap<>();
        for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
            causesBySensor.put(field.sensors().get(sensor), causes(coverage, height, sensor));
        }
        Map<String, Integer> lost = new LinkedHashMap<>();
        Map<String, Integer> changed = new LinkedHashMap<>();
        without.forEach((sensor, rest) -> {
            RemainingCoverage remaining = RemainingCoverage.of(coverage, rest, height);
            lost.put(sensor, remaining.lost());
            changed.put(sensor, remaining.gone() + remaining.gained());
        });
        double volume = covered * grid.cellArea() * grid.depth(height);
        double above = grid.heights().get(height);
        Optional<Gap> gap = Gap.largest(coverage, height);
        return new HeightSummary(
                above, cells, known, inside, covered, volume, causes, causesBySensor, counts, lost, changed, gap);
    }

    /** The causes of one sensor, given by its number. */
    private static Map<Cause, Integer> causes(FieldCoverage coverage, int height, int sensor) {
        Map<Cause, Integer> causes = new EnumMap<>(Cause.class);
        coverage.field().grid().forEachCell((column, row) -> {
            if (coverage.isKnown(height, column, row)) {
                causes.merge(coverage.cause(sensor, height, column, row), 1, Integer::sum);
            }
        });
        return causes;
    }
}
