package org.dronewatch.route;

import java.util.List;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.sensor.CrossingBlind;

/**
 * The fraction of a drone's signal that passes in a sensor that rejects low radial speeds: in flight, and on the
 * courses of a detection field. The courses are numbered, first those on compass headings, then those across the
 * sensor's line of sight. Immutable and thread-safe.
 */
final class RadialResponse {
    /** A drone in flight counts as this much faster, so that rounding does not make it visible where a leg ends. */
    private static final double FASTER = 1.001;

    private final CrossingBlind blind;
    private final Position position;

    /** The motions on the compass headings. */
    private final LegMotion[] motions;

    /** The sides on which the other courses cross the line of sight: 1 clockwise from it, -1 counter-clockwise. */
    private final double[] sides;

    /**
     * The response of a sensor.
     *
     * @param position position of the sensor, m
     * @param motions the motions on the compass headings
     * @param across the courses across the sensor's line of sight
     */
    RadialResponse(CrossingBlind blind, Position position, LegMotion[] motions, List<Course> across) {
        this.blind = blind;
        this.position = position;
        this.motions = motions.clone();
        this.sides = across.stream()
                .mapToDouble(course -> Math.signum(course.angle()))
                .toArray();
    }

    /** The fraction of the signal that passes in flight, 0 to 1. */
    double of(double x, double y, double z, LegMotion motion) {
        double perDistance = perDistance(x, y, z);
        return of(x, y, z, perDistance, motion.east(), motion.north(), motion.up());
    }

    /** The fraction of the signal that passes in flight, with a reserve, 0 to 1. */
    double inFlight(double x, double y, double z, LegMotion motion) {
        double perDistance = FASTER * perDistance(x, y, z);
        return of(x, y, z, perDistance, motion.east(), motion.north(), motion.up());
    }

    private double perDistance(double x, double y, double z) {
        double dx = x - position.x();
        double dy = y - position.y();
        double dz = z - position.z();
        return 1.0 / Math.max(Math.sqrt(dx * dx + dy * dy + dz * dz), Double.MIN_NORMAL);
    }

    private double of(double x, double y, double z, double perDistance, double east, double north, double up) {
        double away = (x - position.x()) * east + (y - position.y()) * north + (z - position.z()) * up;
        return blind.response(perDistance * away);
    }

    /** By course, the fraction that passes at a point, 0 to 1; coordinates in m. */
    double[] onCourses(double x, double y, double z) {
        double perDistance = perDistance(x, y, z);
        double[] passes = new double[motions.length + sides.length];
        for (int course = 0; course < motions.length; course++) {
            LegMotion motion = motions[course];
            passes[course] = of(x, y, z, perDistance, motion.east(), motion.north(), motion.up());
        }
        for (int i = 0; i < sides.length; i++) {
            passes[motions.length + i] = of(x, y, z, perDistance, 0.0, 0.0, motions[0].up());
        }
        return passes;
    }

    /** By course, how near its heading at a point is to that of a flight: the greater, the nearer; coordinates in m. */
    double[] along(double x, double y, LegMotion motion) {
        double[] along = new double[motions.length + sides.length];
        for (int course = 0; course < motions.length; course++) {
            along[course] = motion.east() * motions[course].east() + motion.north() * motions[course].north();
        }
        double turned = motion.east() * (y - position.y()) - motion.north() * (x - position.x());
        for (int i = 0; i < sides.length; i++) {
            along[motions.length + i] = sides[i] * turned;
        }
        return along;
    }
}
