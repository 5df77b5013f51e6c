package org.dronewatch.route;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.layer.InterpolationError;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.CrossingBlind;
import org.dronewatch.sensor.SensorSettings;

/**
 * The rates at which one sensor of a detection field detects a drone in one mode of flight. A sensor whose looks are
 * independent has the rate {@code -f ln(1 - p)} at f looks per second, each of which detects the drone with the
 * probability p; p counts as 1 - 1e-6 at most, so that all rates are finite. One whose chance is drawn once per
 * encounter has its mean hazard over all draws, {@code p^2 / 3.4 s} (see {@link Chance#hazard}): the resulting
 * probability of detection is not too low. Where levels are interpolated, a probability between 0 and 1 represents what
 * is not known about a place, and all looks there have the same outcome: only three of them per distance between traced
 * positions count as independent.
 *
 * <p>In a cell, p is that on the nearest of the field's compass headings. A sensor that rejects low radial speeds
 * states what fraction of the signal passes at the exact radial speed at the exact position: p is then that on the
 * heading on which the same fraction passes at the centre of the cell or, if there is none, is interpolated by level in
 * dB between those on the headings on which less and more of the signal passes. It depends on no other sensor.
 * Immutable and thread-safe.
 */
final class SensorRates {
    /**
     * The number of independent looks per mean distance between traced positions. Near the threshold, these are closer
     * together. The number was checked against flights past microphones that look 2 and 10 times a second.
     */
    private static final double INDEPENDENT = 3.0;

    private final DetectionField field;
    private final int sensor;
    private final FieldCells cells;

    /** Empty if the sensor does not reject low radial speeds. */
    private final Optional<RadialResponse> response;

    /**
     * The numbers of the courses that matter: first the compass headings, then the courses across the line of sight.
     */
    private final int[] courses;

    private final int headings;

    /** The motions on the compass headings. */
    private final LegMotion[] motions;

    /** By step of the probability, 1/s. */
    private final double[] rates = new double[ProbabilityStep.CERTAIN + 1];

    /** By step, the rate at the least probability that is rounded to it, 1/s. */
    private final double[] leastRates = new double[ProbabilityStep.CERTAIN + 1];

    /**
     * The rates of a sensor.
     *
     * @param cells where the cells of the field are
     * @param sensor its number in the field
     */
    SensorRates(ModeField flown, FieldCells cells, int sensor, SceneSettings settings) {
        this.field = flown.field();
        this.sensor = sensor;
        this.cells = cells;
        SensorSettings<?> its = settings.enabledSensors().get(field.sensors().get(sensor));
        List<Course> all = field.courses();
        int[] compass = IntStream.range(0, all.size())
                .filter(i -> all.get(i).kind() == Course.Kind.COMPASS)
                .toArray();
        int[] across = IntStream.range(0, all.size())
                .filter(i -> all.get(i)
                        .sensor()
                        .filter(field.sensors().get(sensor)::equals)
                        .isPresent())
                .toArray();
        this.headings = compass.length;
        this.courses =
                IntStream.concat(IntStream.of(compass), IntStream.of(across)).toArray();
        this.motions = IntStream.of(compass)
                .mapToObj(i -> flown.mode().motion(all.get(i).angle()))
                .toArray(LegMotion[]::new);
        List<Course> crossing = IntStream.of(across).mapToObj(all::get).toList();
        this.response =
                its.as(CrossingBlind.class).map(blind -> new RadialResponse(blind, its.position(), motions, crossing));
        double looks = Math.min(its.rate(), INDEPENDENT * flown.mode().speed() / unknownOver());
        for (int step = 1; step <= ProbabilityStep.CERTAIN; step++) {
            double rate = step == ProbabilityStep.CERTAIN ? its.rate() : looks;
            rates[step] = rate(its, ProbabilityStep.probability(step), rate);
            leastRates[step] = rate(its, ProbabilityStep.least(step), rate);
        }
    }

    /** The mean distance between traced positions; 0 if no level is interpolated, m. */
    private double unknownOver() {
        InterpolationError error = field.interpolated().get(field.sensors().get(sensor));
        if (error == null) {
            return 0.0;
        }
        FieldGrid grid = field.grid();
        double area = field.columnsWithGround() * grid.cell() * grid.cell();
        return Math.sqrt(area * grid.heights().size() / error.places());
    }

    private static double rate(SensorSettings<?> sensor, double probability, double looks) {
        double capped = Math.min(FieldExposure.HIGHEST, probability);
        double hazard = sensor.chance().hazard(capped, looks, capped);
        return sensor.chance() == Chance.PER_LOOK ? hazard : capped * hazard;
    }

    /** The field. */
    DetectionField field() {
        return field;
    }

    /** The number of the sensor in the field. */
    int sensor() {
        return sensor;
    }

    /** The name of the sensor. */
    String name() {
        return field.sensors().get(sensor);
    }

    /** The number of compass headings. */
    int headings() {
        return headings;
    }

    private int step(int level, int column, int row, int course) {
        return field.step(sensor, level, column, row, courses[course]);
    }

    /**
     * The rate that one of some cells, given by its corner, has for a motion, if it is the same at all positions, 1/s;
     * otherwise NaN.
     */
    double steady(CellCorners corners, int corner, LegMotion motion) {
        int level = corners.level(corner);
        int column = corners.column(corner);
        int row = corners.row(corner);
        boolean isSteady = response.isEmpty() || isAlike(level, column, row);
        return isSteady ? rates[step(level, column, row, nearest(motion))] : Double.NaN;
    }

    /** The rate that such a cell has if it depends on the {@linkplain #passing fraction of the signal} that passes. */
    CellRate unsteady(CellCorners corners, int corner, LegMotion motion) {
        int level = corners.level(corner);
        int column = corners.column(corner);
        int row = corners.row(corner);
        int[] steps = new int[courses.length];
        Arrays.setAll(steps, course -> step(level, column, row, course));
        double x = cells.x(column);
        double y = cells.y(row);
        RadialResponse radial = response.orElseThrow();
        return new CellRate(
                rates, steps, radial.onCourses(x, y, cells.z(level, column, row)), radial.along(x, y, motion));
    }

    /** The fraction of the signal that passes at a position, for a sensor that rejects low radial speeds, 0 to 1. */
    double passing(double x, double y, double z, LegMotion motion) {
        return response.orElseThrow().of(x, y, z, motion);
    }

    /**
     * The fraction that {@link #passing} gives, with a reserve, so that rounding does not make a drone visible at the
     * end of a leg.
     */
    double passingInFlight(double x, double y, double z, LegMotion motion) {
        return response.orElseThrow().inFlight(x, y, z, motion);
    }

    /** The course on which the sensor sees most nearly what it sees of a drone at a position, as a cell has it. */
    int course(CellCorners corners, int corner, double x, double y, double z, LegMotion motion) {
        return Double.isNaN(steady(corners, corner, motion))
                ? courses[unsteady(corners, corner, motion).course(passing(x, y, z, motion))]
                : courses[nearest(motion)];
    }

    /**
     * The least rate in a cell on one compass heading, whatever the probabilities were before they were rounded; for a
     * sensor that rejects low radial speeds, the least rate on any course.
     */
    double least(int level, int column, int row, int heading) {
        if (response.isEmpty()) {
            return leastRates[step(level, column, row, heading)];
        }
        int least = ProbabilityStep.CERTAIN;
        for (int course = 0; course < courses.length; course++) {
            least = Math.min(least, step(level, column, row, course));
        }
        return leastRates[least];
    }

    private boolean isAlike(int level, int column, int row) {
        int first = step(level, column, row, 0);
        for (int course = 1; course < courses.length; course++) {
            if (step(level, column, row, course) != first) {
                return false;
            }
        }
        return true;
    }

    /** The compass heading that is nearest to that of a motion. */
    private int nearest(LegMotion motion) {
        int nearest = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < headings; i++) {
            double along = motion.east() * motions[i].east() + motion.north() * motions[i].north();
            nearest = along > most ? i : nearest;
            most = Math.max(along, most);
        }
        return nearest;
    }
}
