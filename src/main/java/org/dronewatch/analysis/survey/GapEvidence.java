package org.dronewatch.analysis.survey;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.Margin;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;

/**
 * Why one sensor does not cover the cells of a gap: in each cell, on the course that determines whether the cell is
 * covered.
 *
 * @param sensor name of the sensor
 * @param causes the number of cells for each cause, in the order of {@link Cause}; {@link Cause#DETECTED} for cells in
 *     which a look detects the drone, but the probability is too low
 * @param examined a few cells for each cause, spread evenly over the cells with that cause, and, where the signal is
 *     too weak, those with the largest and the smallest margin, if the field stores margins; all of these cells are
 *     assessed again, which shows what hides the drone, and by how much its signal is too weak
 */
public record GapEvidence(String sensor, Map<Cause, Integer> causes, List<Examined> examined) {
    /** Maximum number of cells of a gap, spread evenly, that are assessed again for each cause. */
    public static final int MOST_SPREAD = 8;

    /** Copies the map and the list: later changes by the caller have no effect. */
    public GapEvidence {
        causes = Collections.unmodifiableMap(new LinkedHashMap<>(causes));
        examined = List.copyOf(examined);
    }

    /**
     * One cell that was assessed again.
     *
     * @param assessment the assessment by the sensor
     * @param blocker what hides the drone, if something does
     */
    public record Examined(Assessment assessment, Optional<Blocker> blocker) {}

    /**
     * The evidence of each sensor for a gap, on the {@link Workers} of the calling thread; the result does not depend
     * on their number.
     *
     * @param gap number of the gap in the map
     */
    public static List<GapEvidence> of(GapMap map, int gap, Stage stage) {
        int[] cells = map.cells(gap);
        DetectionField field = map.coverage().field();
        List<Map<Cause, List<Integer>>> bySensor = new ArrayList<>();
        List<int[]> chosen = new ArrayList<>();
        for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
            Map<Cause, List<Integer>> byCause = byCause(map, sensor, cells);
            bySensor.add(byCause);
            for (Map.Entry<Cause, List<Integer>> one : byCause.entrySet()) {
                List<Integer> its = one.getValue();
                SortedSet<Integer> some = new TreeSet<>(spread(its));
                if (one.getKey() == Cause.TOO_WEAK) {
                    some.addAll(extremes(map, sensor, its));
                }
                for (int cell : some) {
                    chosen.add(new int[] {sensor, cell});
                }
            }
        }
        Examined[] examined = new Examined[chosen.size()];
        Workers.forEach(
                examined.length,
                () -> new BlockerSearch(stage),
                (search, i) -> examined[i] = examine(map, chosen.get(i)[0], chosen.get(i)[1], search));
        List<GapEvidence> all = new ArrayList<>();
        for (int sensor = 0; sensor < bySensor.size(); sensor++) {
            Map<Cause, Integer> causes = new EnumMap<>(Cause.class);
            bySensor.get(sensor).forEach((cause, its) -> causes.put(cause, its.size()));
            List<Examined> its = new ArrayList<>();
            for (int i = 0; i < examined.length; i++) {
                if (chosen.get(i)[0] == sensor) {
                    its.add(examined[i]);
                }
            }
            all.add(new GapEvidence(field.sensors().get(sensor), causes, its));
        }
        return all;
    }

    /** Some of the cells, spread evenly: those in the middle of equal parts; all cells if there are few. */
    private static List<Integer> spread(List<Integer> cells) {
        long count = Math.min(cells.size(), MOST_SPREAD);
        List<Integer> some = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            some.add(cells.get((int) ((2L * i + 1) * cells.size() / (2L * count))));
        }
        return some;
    }

    /** The cells with the greatest and the least margin; none unless values are kept for some of them. */
    private static List<Integer> extremes(GapMap map, int sensor, List<Integer> cells) {
        Comparator<Integer> byMargin =
                Comparator.comparingDouble(cell -> margin(map, sensor, cell).db());
        List<Integer> known = cells.stream()
                .filter(cell -> margin(map, sensor, cell).kind() == Margin.Known.VALUE)
                .toList();
        return known.isEmpty()
                ? List.of()
                : List.of(Collections.min(known, byMargin), Collections.max(known, byMargin));
    }

    private static Margin margin(GapMap map, int sensor, int cell) {
        FieldGrid grid = map.coverage().field().grid();
        int column = grid.column(cell);
        int row = grid.row(cell);
        int course = map.coverage().courseAt(map.height(), column, row);
        return map.coverage().field().margin(sensor, map.height(), column, row, course);
    }

    private static Map<Cause, List<Integer>> byCause(GapMap map, int sensor, int[] cells) {
        FieldCoverage coverage = map.coverage();
        FieldGrid grid = coverage.field().grid();
        Map<Cause, List<Integer>> byCause = new EnumMap<>(Cause.class);
        for (int cell : cells) {
            int column = grid.column(cell);
            int row = grid.row(cell);
            Cause cause = coverage.cause(sensor, map.height(), column, row);
            byCause.computeIfAbsent(cause, one -> new ArrayList<>()).add(cell);
        }
        return byCause;
    }

    private static Examined examine(GapMap map, int sensor, int cell, BlockerSearch search) {
        FieldGrid grid = map.coverage().field().grid();
        return examine(map.coverage(), sensor, map.height(), grid.column(cell), grid.row(cell), search);
    }

    /** Assesses a cell in which a drone can be. */
    static Examined examine(FieldCoverage coverage, int sensor, int height, int column, int row, BlockerSearch search) {
        DetectionField field = coverage.field();
        int course = coverage.courseAt(height, column, row);
        Assessment assessment = field.assess(sensor, height, column, row, course)
                .orElseThrow(() ->
                        new IllegalStateException("no drone can enter cell " + column + ", " + row + " of a gap"));
        return new Examined(
                assessment,
                assessment
                        .obstacle()
                        .map(named ->
                                search.between(field.position(sensor), field.middle(height, column, row), named)));
    }
}
