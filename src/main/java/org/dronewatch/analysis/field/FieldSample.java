package org.dronewatch.analysis.field;

import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.world.World;

/**
 * What the sensors of a field detect at 4,096 positions between the centres of its cells. In plan view, the positions
 * are spread evenly between the centres of the outermost columns; vertically, they lie between the lowest and the
 * highest height of the grid, half of them in the range of the lowest quarter of these heights, near the ground, where
 * a drone finds something to hide behind. They are the points of the additive sequence R3 (M. Roberts, "The
 * unreasonable effectiveness of quasirandom sequences", 2018), the same for every field of the same grid. Immutable.
 */
public final class FieldSample {
    private static final int COUNT = 4096;

    /** The places are assessed in rows, each by one thread. */
    private static final int COLUMNS = 64;

    /** The root of g^4 = g + 1. */
    private static final double G = 1.2207440846057596;

    private final FieldGrid grid;
    private final FieldColumns places;
    private final BitSet undetected;

    private FieldSample(FieldGrid grid, FieldColumns places, BitSet undetected) {
        this.grid = grid;
        this.places = places;
        this.undetected = undetected;
    }

    /**
     * Assesses a field's sensors on each of its courses, on the {@link Workers} of the calling thread: each sensor only
     * where those before it do not detect the drone. Sensors that search come last, since each of their assessments
     * covers many pointings.
     *
     * @param which selects the positions, m, at which the sensors are assessed; positions at which the drone cannot be
     *     are left out in any case
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static FieldSample of(DetectionField field, Predicate<Position> which) {
        FieldSensors sensors = field.all();
        World world = sensors.probe(0).world();
        Spread spread = new Spread(field.grid());
        FieldColumns places = columns(world, spread);
        BitSet undetected = new BitSet(COUNT);
        for (int place = 0; place < COUNT; place++) {
            undetected.set(
                    place, isOpen(places, place) && which.test(places.middle(0, place % COLUMNS, place / COLUMNS)));
        }
        List<Integer> order = IntStream.range(0, sensors.names().size())
                .boxed()
                .sorted(Comparator.comparing(
                        sensor -> sensors.probe(sensor).search().isPresent()))
                .toList();
        for (int sensor : order) {
            FieldColumns asked = columns(world, new Chosen(spread, (BitSet) undetected.clone()));
            FieldSensors alone =
                    sensors.only(sensor).in(asked, LayerStore.NONE, field.grid().toString(), "sample", cells -> {});
            undetected.stream()
                    .filter(place -> isOpen(asked, place) && isDetected(alone, place))
                    .boxed()
                    .toList()
                    .forEach(undetected::clear);
        }
        return new FieldSample(field.grid(), places, undetected);
    }

    /**
     * This sample combined with another: the drone counts as undetected at a position if it is undetected there in
     * either sample.
     *
     * @param other sample of a field of the same site and grid, such as for the same drone with its motors off
     * @throws IllegalArgumentException if the grids differ
     */
    public FieldSample either(FieldSample other) {
        if (!grid.equals(other.grid)) {
            throw new IllegalArgumentException("a sample of " + other.grid + ": its grid must be " + grid);
        }
        BitSet both = (BitSet) undetected.clone();
        both.or(other.undetected);
        return new FieldSample(grid, places, both);
    }

    private static boolean isOpen(FieldColumns columns, int place) {
        return columns.isOpen(0, place % COLUMNS, place / COLUMNS);
    }

    private static boolean isDetected(FieldSensors alone, int place) {
        return IntStream.range(0, alone.courses().size())
                .map(course -> alone.step(0, 0, place % COLUMNS, place / COLUMNS, course))
                .anyMatch(step -> ProbabilityStep.least(step) > 0.0);
    }

    private static FieldColumns columns(World world, FieldColumns.Plan plan) {
        return new FieldColumns(world, COLUMNS, COUNT / COLUMNS, 1, plan);
    }

    /** Some of the points. */
    private record Chosen(Spread all, BitSet which) implements FieldColumns.Plan {
        @Override
        public double x(int column, int row) {
            return all.x(column, row);
        }

        @Override
        public double y(int column, int row) {
            return all.y(column, row);
        }

        @Override
        public double above(int level, int column, int row) {
            return all.above(level, column, row);
        }

        @Override
        public boolean isOutside(int column, int row) {
            return !which.get(row * COLUMNS + column);
        }
    }

    /** Points of the sequence in a grid. */
    private record Spread(FieldGrid grid) implements FieldColumns.Plan {
        @Override
        public double x(int column, int row) {
            return grid.east() + (part(column, row, 1) - 0.5) * extent();
        }

        @Override
        public double y(int column, int row) {
            return grid.north() + (part(column, row, 2) - 0.5) * extent();
        }

        private double extent() {
            return (grid.columns() - 1) * grid.cell();
        }

        @Override
        public double above(int level, int column, int row) {
            double share = part(column, row, 3);
            double number = share * share * (grid.heights().size() - 1);
            int lower = Math.min((int) number, Math.max(0, grid.heights().size() - 2));
            int upper = Math.min(lower + 1, grid.heights().size() - 1);
            double low = grid.heights().get(lower);
            return low + (number - lower) * (grid.heights().get(upper) - low);
        }

        @Override
        public boolean isOutside(int column, int row) {
            return grid.area().isPresent() && !grid.area().get().covers(x(column, row), y(column, row));
        }

        /** A coordinate of a point, 0 to 1. */
        private static double part(int column, int row, int axis) {
            double at = 0.5 + (row * COLUMNS + column + 1) * Math.pow(G, -axis);
            return at - Math.floor(at);
        }
    }

    /** The number of positions at which a drone can be: with ground below them, and nothing solid around them. */
    public int openCount() {
        return places.openCount();
    }

    /**
     * The number of positions at which the sensors were assessed, and none of them detects the drone with a probability
     * above 0, on any course.
     */
    public int undetectedCount() {
        return undetected.cardinality();
    }
}
