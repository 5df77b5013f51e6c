package org.dronewatch.route;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.GaussRule;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Cause;

/**
 * The rates of detection that follow from a detection field of single looks, in one mode of flight: those of the
 * nearest cell, where each height represents the air up to halfway to the next lower and the next higher height
 * ({@link SensorRates}). Where a drone cannot be, the rates are 0: no route leads there.
 */
public final class FieldExposure implements ExposureField {
    /** The value at which the probability of detection in a look is capped, so that all exposures are finite. */
    public static final double HIGHEST = 1.0 - 1e-6;

    /** The number of parts into which pieces are divided where a radar may be blind to part of a cell. */
    private static final int PARTS = 4;

    private final DetectionField field;
    private final FieldCells cells;
    private final RouteMode mode;

    /** In the order of their names: the order of the scene does not change a bit of a sum. */
    private final List<SensorRates> sensors;

    private FieldExposure(DetectionField field, RouteMode mode, List<SensorRates> sensors) {
        this.field = field;
        this.cells = new FieldCells(field);
        this.mode = mode;
        this.sensors = sensors;
    }

    /**
     * The exposure to all sensors of a field.
     *
     * @param flown the mode of flight with its field of single looks, with all {@linkplain Course#all courses}
     * @param settings settings of the scene
     * @throws IllegalArgumentException if the field has no compass headings
     */
    public static FieldExposure of(ModeField flown, SceneSettings settings) {
        DetectionField field = flown.field();
        if (field.courses().stream().noneMatch(course -> course.kind() == Course.Kind.COMPASS)) {
            throw new IllegalArgumentException("the field has no compass headings, but must have all courses");
        }
        List<SensorRates> sensors = IntStream.range(0, field.sensors().size())
                .boxed()
                .sorted(Comparator.comparing(field.sensors()::get))
                .map(sensor -> new SensorRates(flown, sensor, settings))
                .toList();
        return new FieldExposure(field, flown.mode(), sensors);
    }

    /** The exposure to one sensor alone, given by its name. */
    FieldExposure ofSensor(String name) {
        return new FieldExposure(
                field,
                mode,
                sensors.stream().filter(one -> one.name().equals(name)).toList());
    }

    /** The exposure to the sensors of several fields, all of the same grid and in the same mode as this one. */
    FieldExposure toAll(List<FieldExposure> others) {
        return new FieldExposure(
                field,
                mode,
                others.stream()
                        .flatMap(one -> one.sensors.stream())
                        .sorted(Comparator.comparing(SensorRates::name))
                        .toList());
    }

    @Override
    public double rate(double x, double y, double z, LegMotion motion, int number) {
        int column = cells.column(x);
        int row = cells.row(y);
        int level = cells.level(column, row, z);
        double sum = 0.0;
        for (int i = 0; level >= 0 && i < sensors.size(); i++) {
            sum += sensors.get(i).rate(level, column, row, x, y, z, motion);
        }
        return sum;
    }

    /** {@inheritDoc} The leg is split where it passes from one cell into another. */
    @Override
    public double mean(Position from, Position to, LegMotion motion, int number, double longest) {
        double finest = longest / PARTS / from.distance(to);
        double sum = 0.0;
        double at = 0.0;
        while (at < 1.0) {
            double until = cells.leaves(from, to, at);
            sum += (until - at) * meanInCell(from, to, at, until, motion, finest);
            at = until;
        }
        return sum;
    }

    /**
     * The mean rate on a part of a leg that lies in one cell.
     *
     * @param begin the fraction of the leg at which it begins
     * @param end the fraction at which it ends
     * @param finest the greatest fraction of the leg that is a piece where the rate depends on the position in the cell
     */
    private double meanInCell(Position from, Position to, double begin, double end, LegMotion motion, double finest) {
        double middle = 0.5 * (begin + end);
        double x = from.x() + middle * (to.x() - from.x());
        double y = from.y() + middle * (to.y() - from.y());
        double z = from.z() + middle * (to.z() - from.z());
        int column = cells.column(x);
        int row = cells.row(y);
        int level = cells.level(column, row, z);
        int pieces = (int) Math.ceil((end - begin) / finest);
        double sum = 0.0;
        for (int i = 0; level >= 0 && i < sensors.size(); i++) {
            SensorRates sensor = sensors.get(i);
            if (sensor.isConstant(level, column, row)) {
                sum += sensor.rate(level, column, row, x, y, z, motion);
                continue;
            }
            double parts = 0.0;
            for (int piece = 0; piece < pieces; piece++) {
                for (int point = 0; point < GaussRule.POINTS; point++) {
                    double share = begin + (piece + GaussRule.at(point)) / pieces * (end - begin);
                    parts += GaussRule.weight(point)
                            * sensor.rate(
                                    level,
                                    column,
                                    row,
                                    from.x() + share * (to.x() - from.x()),
                                    from.y() + share * (to.y() - from.y()),
                                    from.z() + share * (to.z() - from.z()),
                                    motion);
                }
            }
            sum += parts / pieces;
        }
        return sum;
    }

    /**
     * The dominant cause in the middle of a straight leg that lies in one cell: that of the sensor with the highest
     * probability; in a tie, the one that is nearest to a detection.
     */
    Cause cause(Position from, Position to) {
        Position at = from.plus(to).times(0.5);
        int column = cells.column(at.x());
        int row = cells.row(at.y());
        int level = cells.level(column, row, at.z());
        if (level < 0 || !field.isOpen(level, column, row)) {
            return Cause.UNKNOWN;
        }
        Position along = to.minus(from);
        double time = mode.time(Math.hypot(along.x(), along.y()), along.z());
        LegMotion motion = LegMotion.along(along.x(), along.y(), along.z(), time);
        Cause dominant = Cause.UNKNOWN;
        int most = -1;
        for (SensorRates sensor : sensors) {
            int course = sensor.course(level, column, row, at.x(), at.y(), at.z(), motion);
            int steps = sensor.field().steps(sensor.sensor(), level, column, row, course);
            Cause cause = sensor.field().cause(sensor.sensor(), level, column, row, course);
            if (steps > most || steps == most && cause.compareTo(dominant) > 0) {
                dominant = cause;
                most = steps;
            }
        }
        return dominant;
    }

    /**
     * The least of the rates on all courses except hovering, in all cells that the box touches and in which a drone can
     * be.
     */
    @Override
    public double least(Position low, Position high, int number) {
        double least = Double.POSITIVE_INFINITY;
        for (int row = cells.row(high.y()); row <= cells.row(low.y()); row++) {
            for (int column = cells.column(low.x()); column <= cells.column(high.x()); column++) {
                int last = cells.level(column, row, high.z());
                for (int level = Math.max(0, cells.level(column, row, low.z())); level <= last; level++) {
                    least = Math.min(least, least(level, column, row));
                }
            }
        }
        return least == Double.POSITIVE_INFINITY ? 0.0 : least;
    }

    /** The least exposure on any compass heading, at any speed. */
    private double least(int level, int column, int row) {
        if (sensors.isEmpty() || !field.isOpen(level, column, row)) {
            return 0.0;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int heading = 0; heading < sensors.get(0).headings(); heading++) {
            double sum = 0.0;
            for (SensorRates sensor : sensors) {
                sum += sensor.least(level, column, row, heading);
            }
            least = Math.min(least, sum);
        }
        return least;
    }
}
