package org.dronewatch.analysis.field;

import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;

/**
 * What the sensors of a field detect at places between the middles of its cells. The places are spread evenly between
 * the middles of the outermost columns and between the lowest and the highest height: they are the points of the
 * additive sequence R3 (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018), the same for
 * every field of the same grid. Immutable.
 */
public final class FieldSample {
    /** The number of places. */
    public static final int COUNT = 4096;

    /** The places are assessed in rows, each by one thread. */
    private static final int COLUMNS = 64;

    /** The root of g^4 = g + 1. */
    private static final double G = 1.2207440846057596;

    private final FieldColumns places;
    private final FieldSensors sensors;

    private FieldSample(FieldColumns places, FieldSensors sensors) {
        this.places = places;
        this.sensors = sensors;
    }

    /** Assesses the sensors of a field on its courses, on the {@link Workers} of the calling thread. */
    public static FieldSample of(DetectionField field) {
        FieldColumns places =
                new FieldColumns(field.all().probe(0).world(), COLUMNS, COUNT / COLUMNS, 1, new Spread(field.grid()));
        return new FieldSample(
                places, field.all().in(places, LayerStore.NONE, field.grid().toString(), "sample", cells -> {}));
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
            double lowest = grid.heights().get(0);
            double highest = grid.heights().get(grid.heights().size() - 1);
            return lowest + part(column, row, 3) * (highest - lowest);
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

    /** Whether a drone can be at a place, given by its number: over ground, and with nothing solid around it. */
    public boolean isOpen(int place) {
        return places.isOpen(0, column(place), row(place));
    }

    /** A place with ground below it, m. */
    public Position position(int place) {
        return places.middle(0, column(place), row(place));
    }

    /** Whether no sensor is known to detect the drone at a place, on any course, with a probability above 0. */
    public boolean isUndetected(int place) {
        return IntStream.range(0, sensors.names().size())
                .allMatch(sensor -> IntStream.range(0, sensors.courses().size())
                        .map(course -> sensors.step(sensor, 0, column(place), row(place), course))
                        .allMatch(step -> ProbabilityStep.least(step) == 0.0));
    }

    private static int column(int place) {
        return place % COLUMNS;
    }

    private static int row(int place) {
        return place / COLUMNS;
    }
}
