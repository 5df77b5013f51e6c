package org.dronewatch.route;

import java.util.ArrayList;
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
 * The rates of detection that follow from a detection field of single looks, in one mode of flight. At the centre of a
 * cell, the rate of a sensor follows from the probability of detection in a look there and the number of looks per
 * second ({@link org.dronewatch.sensor.Chance#hazard}); between the centres of eight cells, at two neighbouring heights
 * of the field above the ground, rates are interpolated (trilinearly), so that no route exploits a step in the rate at
 * a cell boundary, which is an artefact of the grid. The rates are 0 where a drone cannot be, since no route leads
 * there.
 */
public final class FieldExposure implements ExposureField {
    /** The value at which the probability of detection in a look is capped, so that all exposures are finite. */
    public static final double HIGHEST = 1.0 - 1e-6;

    /** The number of parts into which pieces are divided where a radar may be blind to part of a cell. */
    private static final int PARTS = 4;

    private final DetectionField field;
    private final FieldCells cells;
    private final RouteMode mode;

    /** In the order of their names, so that the order of the scene does not change a single bit of a sum. */
    private final List<SensorRates> sensors;

    private FieldExposure(DetectionField field, FieldCells cells, RouteMode mode, List<SensorRates> sensors) {
        this.field = field;
        this.cells = cells;
        this.mode = mode;
        this.sensors = sensors;
    }

    /**
     * The exposure to all sensors of a field.
     *
     * @param flown the mode of flight and its field of single looks, assessed on all {@linkplain Course#all courses}
     * @param settings settings of the scene
     * @throws IllegalArgumentException if the field has no compass headings
     */
    public static FieldExposure of(ModeField flown, SceneSettings settings) {
        DetectionField field = flown.field();
        if (field.courses().stream().noneMatch(course -> course.kind() == Course.Kind.COMPASS)) {
            throw new IllegalArgumentException(
                    "the field has no compass headings: it must be assessed on the courses of Course.all()");
        }
        FieldCells cells = new FieldCells(field);
        List<SensorRates> sensors = IntStream.range(0, field.sensors().size())
                .boxed()
                .sorted(Comparator.comparing(field.sensors()::get))
                .map(sensor -> new SensorRates(flown, cells, sensor, settings))
                .toList();
        return new FieldExposure(field, cells, flown.mode(), sensors);
    }

    /** The exposure to one sensor alone, given by its name. */
    FieldExposure ofSensor(String name) {
        return new FieldExposure(
                field,
                cells,
                mode,
                sensors.stream().filter(one -> one.name().equals(name)).toList());
    }

    /** The exposure to the sensors of several fields, all of the same grid and in the same mode as this one. */
    FieldExposure toAll(List<FieldExposure> others) {
        return new FieldExposure(
                field,
                cells,
                mode,
                others.stream()
                        .flatMap(one -> one.sensors.stream())
                        .sorted(Comparator.comparing(SensorRates::name))
                        .toList());
    }

    @Override
    public double rate(double x, double y, double z, LegMotion motion, int number) {
        CellCorners corners = new CellCorners(field, cells);
        corners.around(x, y, z);
        corners.weigh(x, y, z);
        double sum = 0.0;
        for (int corner = 0; corner < CellCorners.COUNT; corner++) {
            double weight = corners.weight(corner);
            for (int i = 0; weight > 0.0 && i < sensors.size(); i++) {
                sum += weight * rate(sensors.get(i), corners, corner, x, y, z, motion);
            }
        }
        return sum;
    }

    private static double rate(
            SensorRates sensor, CellCorners corners, int corner, double x, double y, double z, LegMotion motion) {
        double steady = sensor.steady(corners, corner, motion);
        return Double.isNaN(steady)
                ? sensor.unsteady(corners, corner, motion).at(sensor.passing(x, y, z, motion))
                : steady;
    }

    /** {@inheritDoc} The leg is split wherever it crosses from one set of eight cell centres to the next. */
    @Override
    public double mean(Position from, Position to, LegMotion motion, int number, double longest) {
        CellCorners corners = new CellCorners(field, cells);
        double finest = longest / PARTS / from.distance(to);
        double sum = 0.0;
        double at = 0.0;
        while (at < 1.0) {
            double until = cells.leaves(from, to, at);
            sum += (until - at) * mean(corners, new LegPart(from, to, at, until), motion, finest);
            at = until;
        }
        return sum;
    }

    /**
     * The mean rate on a part of a leg that lies between the centres of the same cells.
     *
     * @param finest the greatest length of a piece, as a fraction of the leg, where the rate depends on the position in
     *     the cell
     */
    private double mean(CellCorners corners, LegPart part, LegMotion motion, double finest) {
        corners.around(part.x(0.5), part.y(0.5), part.z(0.5));
        double[] weights = new double[CellCorners.COUNT];
        for (int point = 0; point < GaussRule.POINTS; point++) {
            double share = GaussRule.at(point);
            corners.weigh(part.x(share), part.y(share), part.z(share));
            corners.addTo(weights, GaussRule.weight(point));
        }
        double sum = 0.0;
        for (int i = 0; i < sensors.size(); i++) {
            SensorRates sensor = sensors.get(i);
            CellRate[] unsteady = null;
            for (int corner = 0; corner < CellCorners.COUNT; corner++) {
                if (weights[corner] > 0.0) {
                    double steady = sensor.steady(corners, corner, motion);
                    if (Double.isNaN(steady)) {
                        unsteady = unsteady == null ? new CellRate[CellCorners.COUNT] : unsteady;
                        unsteady[corner] = sensor.unsteady(corners, corner, motion);
                    } else {
                        sum += weights[corner] * steady;
                    }
                }
            }
            sum += unsteady == null ? 0.0 : new UnsteadyPart(sensor, unsteady, corners, part, motion).mean(finest);
        }
        return sum;
    }

    /** Why each sensor does not detect the drone at the midpoint of a straight leg that lies in one cell. */
    List<SensorCause> causes(Position from, Position to) {
        Position at = from.plus(to).times(0.5);
        CellCorners corners = new CellCorners(field, cells);
        corners.around(at.x(), at.y(), at.z());
        corners.weigh(at.x(), at.y(), at.z());
        int nearest = corners.nearest();
        if (nearest < 0) {
            return sensors.stream()
                    .map(sensor -> new SensorCause(sensor.name(), 0, Cause.UNKNOWN))
                    .toList();
        }
        int column = corners.column(nearest);
        int row = corners.row(nearest);
        int level = corners.level(nearest);
        Position along = to.minus(from);
        double time = mode.time(Math.hypot(along.x(), along.y()), along.z());
        LegMotion motion = LegMotion.along(along.x(), along.y(), along.z(), time);
        List<SensorCause> causes = new ArrayList<>();
        for (SensorRates sensor : sensors) {
            int course = sensor.course(corners, nearest, at.x(), at.y(), at.z(), motion);
            causes.add(new SensorCause(
                    sensor.name(),
                    sensor.field().step(sensor.sensor(), level, column, row, course),
                    sensor.field().cause(sensor.sensor(), level, column, row, course)));
        }
        return causes;
    }

    /**
     * {@inheritDoc} The bound is the least rate on any course except hovering, in any cell that may contribute to the
     * rate at a point of the box; 0 if a drone cannot be in one of these cells.
     */
    @Override
    public double least(Position low, Position high, int number) {
        int[] columns = cells.columns(low, high);
        int[] rows = cells.rows(low, high);
        int[] levels = cells.levels(low, high);
        double least = Double.POSITIVE_INFINITY;
        for (int row = rows[0]; row <= rows[1]; row++) {
            for (int column = columns[0]; column <= columns[1]; column++) {
                for (int level = levels[0]; level <= levels[1]; level++) {
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
