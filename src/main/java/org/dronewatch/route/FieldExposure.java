package org.dronewatch.route;

import java.util.Comparator;
import java.util.stream.IntStream;
import org.dronewatch.analysis.field.Course;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.SensorSettings;

/**
 * The rates of detection that follow from a detection field of single looks: constant in each cell, and from half the
 * distance to the next lower height to half that to the next higher one. A sensor whose looks are independent has the
 * rate {@code -f ln(1 - p)}, where p counts as 1 - 1e-6 at most, so that all rates are finite. One whose chance is
 * drawn once per encounter has its mean hazard over all draws, {@code p^2 / 3.4 s} (see {@link Chance#hazard}): the
 * resulting probability of detection is not too low.
 *
 * <p>The rates are those of the nearest of the field's compass headings or, within 5 degrees, across the line of
 * sight of the sensor; another sensor does not change them. Where the field is not open, rates are 0: no route leads
 * there.
 */
public final class FieldExposure implements ExposureField {
    /** The most that the probability of a look counts as, so that all exposures are finite. */
    public static final double HIGHEST = 1.0 - 1e-6;

    /** The sine of 5 degrees. */
    private static final double NARROW = 0.08715574274765817;

    private static final int STEPS = 250;

    private final DetectionField field;
    private final FieldGrid grid;
    private final Course[] courses;

    /** By sensor and step of the probability, 1/s. */
    private final double[][] rates;

    /** The sensors that count, in the order of their names: the order of the scene does not change a bit of a sum. */
    private final int[] sensors;

    /** By sensor, the numbers of the courses across its line of sight. */
    private final int[][] crossings;

    private FieldExposure(DetectionField field, double[][] rates, int... sensors) {
        this.field = field;
        this.grid = field.grid();
        this.courses = field.courses().toArray(Course[]::new);
        this.rates = rates;
        this.sensors = sensors;
        this.crossings = field.sensors().stream()
                .map(sensor -> IntStream.range(0, courses.length)
                        .filter(i -> courses[i].sensor().filter(sensor::equals).isPresent())
                        .toArray())
                .toArray(int[][]::new);
    }

    /**
     * The exposure to all sensors of a field.
     *
     * @param field of single looks, with all {@linkplain Course#all courses}
     * @param settings of its scene
     * @throws IllegalArgumentException if the field has no compass headings
     */
    public static FieldExposure of(DetectionField field, SceneSettings settings) {
        if (field.courses().stream().noneMatch(course -> course.kind() == Course.Kind.COMPASS)) {
            throw new IllegalArgumentException("the field has no compass headings: it must have all courses");
        }
        double[][] rates = new double[field.sensors().size()][STEPS + 1];
        for (int sensor = 0; sensor < rates.length; sensor++) {
            SensorSettings<?> one =
                    settings.enabledSensors().get(field.sensors().get(sensor));
            for (int step = 1; step <= STEPS; step++) {
                rates[sensor][step] = rate(one, (double) step / STEPS);
            }
        }
        int[] byName = IntStream.range(0, rates.length)
                .boxed()
                .sorted(Comparator.comparing(field.sensors()::get))
                .mapToInt(Integer::intValue)
                .toArray();
        return new FieldExposure(field, rates, byName);
    }

    private static double rate(SensorSettings<?> sensor, double probability) {
        double capped = Math.min(HIGHEST, probability);
        double hazard = sensor.chance().hazard(capped, sensor.rate(), capped);
        return sensor.chance() == Chance.PER_LOOK ? hazard : capped * hazard;
    }

    /** The exposure to one sensor alone, given by its number in the field. */
    public FieldExposure ofSensor(int sensor) {
        return new FieldExposure(field, rates, sensor);
    }

    @Override
    public double rate(double x, double y, double z, double heading, int mode) {
        int column = column(x);
        int row = row(y);
        double ground = field.ground(column, row);
        if (Double.isNaN(ground)) {
            return 0.0;
        }
        int level = level(z - ground);
        int compass = compass(heading);
        double east = StrictMath.sin(heading);
        double north = StrictMath.cos(heading);
        double sum = 0.0;
        for (int sensor : sensors) {
            int course = course(sensor, compass, x, y, heading, east, north);
            sum += rates[sensor][field.steps(sensor, level, column, row, course)];
        }
        return sum;
    }

    /**
     * The dominant cause in the middle of a straight leg that lies in one cell: that of the sensor with the highest
     * probability and, among equals, the one that is nearest to a detection.
     */
    Cause cause(Position from, Position to) {
        Position at = from.plus(to).times(0.5);
        int column = column(at.x());
        int row = row(at.y());
        double ground = field.ground(column, row);
        int level = Double.isNaN(ground) ? -1 : level(at.z() - ground);
        if (level < 0 || !field.isOpen(level, column, row)) {
            return Cause.UNKNOWN;
        }
        double heading = StrictMath.atan2(to.x() - from.x(), to.y() - from.y());
        int compass = compass(heading);
        double east = StrictMath.sin(heading);
        double north = StrictMath.cos(heading);
        Cause dominant = Cause.UNKNOWN;
        int most = -1;
        for (int sensor : sensors) {
            int course = course(sensor, compass, at.x(), at.y(), heading, east, north);
            int steps = field.steps(sensor, level, column, row, course);
            Cause cause = field.cause(sensor, level, column, row, course);
            if (steps > most || steps == most && cause.compareTo(dominant) > 0) {
                dominant = cause;
                most = steps;
            }
        }
        return dominant;
    }

    /** The least of the rates on all courses but hovering, in all cells that the box touches and that are open. */
    @Override
    public double least(Position low, Position high, int mode) {
        double least = Double.POSITIVE_INFINITY;
        for (int row = row(high.y()); row <= row(low.y()); row++) {
            for (int column = column(low.x()); column <= column(high.x()); column++) {
                double ground = field.ground(column, row);
                int last = Double.isNaN(ground) ? -1 : level(high.z() - ground);
                for (int level = last < 0 ? 0 : level(low.z() - ground); level <= last; level++) {
                    least = Math.min(least, least(level, column, row));
                }
            }
        }
        return least == Double.POSITIVE_INFINITY ? 0.0 : least;
    }

    /** On any compass heading, of each sensor the lower of the rates there and across its line of sight. */
    private double least(int level, int column, int row) {
        if (!field.isOpen(level, column, row)) {
            return 0.0;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int course = 0; course < courses.length; course++) {
            if (courses[course].kind() == Course.Kind.COMPASS) {
                double sum = 0.0;
                for (int sensor : sensors) {
                    double rate = rates[sensor][field.steps(sensor, level, column, row, course)];
                    for (int crossing : crossings[sensor]) {
                        rate = Math.min(rate, rates[sensor][field.steps(sensor, level, column, row, crossing)]);
                    }
                    sum += rate;
                }
                least = Math.min(least, sum);
            }
        }
        return least;
    }

    private int column(double x) {
        return clamp((x - grid.x(0)) / grid.cell());
    }

    private int row(double y) {
        return clamp((grid.y(0) - y) / grid.cell());
    }

    private int clamp(double index) {
        return (int) Math.max(0.0, Math.min(grid.columns() - 1.0, Math.rint(index)));
    }

    /** The height that is nearest. */
    private int level(double above) {
        int nearest = 0;
        for (int i = 1; i < grid.heights().size(); i++) {
            boolean isNearer = Math.abs(grid.heights().get(i) - above)
                    < Math.abs(grid.heights().get(nearest) - above);
            nearest = isNearer ? i : nearest;
        }
        return nearest;
    }

    /** The compass heading that is nearest to a heading. */
    private int compass(double heading) {
        int nearest = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < courses.length; i++) {
            if (courses[i].kind() == Course.Kind.COMPASS) {
                double angle = angle(i, heading);
                nearest = angle < least ? i : nearest;
                least = Math.min(least, angle);
            }
        }
        return nearest;
    }

    private double angle(int compass, double heading) {
        return Math.abs(Math.IEEEremainder(courses[compass].angle() - heading, 2.0 * Math.PI));
    }

    /** The course that counts for a sensor: the nearest on the compass or, if nearer, across its line of sight. */
    private int course(int sensor, int compass, double x, double y, double heading, double east, double north) {
        int nearest = compass;
        double least = crossings[sensor].length == 0 ? 0.0 : angle(compass, heading);
        for (int i : crossings[sensor]) {
            double angle = crossing(courses[i], x, y, east, north);
            nearest = angle < least ? i : nearest;
            least = Math.min(least, angle);
        }
        return nearest;
    }

    /** The angle between a heading and a course across a line of sight; infinite if it is not small, rad. */
    private static double crossing(Course course, double x, double y, double east, double north) {
        double dx = x - course.reference().x();
        double dy = y - course.reference().y();
        double distance = Math.sqrt(dx * dx + dy * dy);
        double along = Math.abs(dx * east + dy * north);
        double right = dy * east - dx * north;
        boolean isThisSide = right * course.angle() >= 0.0;
        return isThisSide && along <= NARROW * distance && distance > 0.0
                ? StrictMath.asin(along / distance)
                : Double.POSITIVE_INFINITY;
    }
}
