package org.dronewatch.analysis.cell;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.CrossingBlind;
import org.dronewatch.sensor.SensorSettings;

/**
 * How a drone flies through a cell: level and nose first, at its cruise speed or another speed; hovering; or gliding
 * down.
 *
 * @param kind what determines the heading
 * @param angle for {@link Kind#COMPASS} and {@link Kind#HOVER}, the heading, clockwise from north, rad; otherwise the
 *     clockwise angle from a bearing to the heading, rad: for {@link Kind#CROSSING}, the bearing of the drone from the
 *     reference point; for {@link Kind#INBOUND}, that of the reference point from the drone
 * @param reference the sensor from which the bearing of the drone is measured, or the point to which an inbound drone
 *     flies, m; without effect on a fixed heading
 * @param sensor name of the sensor whose line of sight is crossed; empty for other kinds
 * @param glide how the drone glides; empty under power
 * @param speed speed of the drone, m/s; empty for its cruise speed, and if it hovers or glides
 */
public record Course(
        Kind kind,
        double angle,
        Position reference,
        Optional<String> sensor,
        Optional<GlideDescent> glide,
        OptionalDouble speed) {
    /** Number of compass directions among the courses. */
    public static final int COMPASS_POINTS = 8;

    private static final Position NOWHERE = new Position(0, 0, 0);

    /** What determines the heading. */
    public enum Kind {
        /** A direction of the compass. */
        COMPASS,
        /** Across the line of sight of a sensor. */
        CROSSING,
        /** Hovering, with the nose to the north. */
        HOVER,
        /** Towards a point. */
        INBOUND
    }

    /**
     * The courses among which the worst and the best for a site are chosen: eight directions of the compass, both
     * directions across the line of sight of each sensor that may miss a crossing drone, and hovering, if the drone can
     * hover.
     *
     * @param sensors the sensors, by name
     */
    public static List<Course> all(Map<String, SensorSettings<?>> sensors, Drone drone) {
        List<Course> courses = new ArrayList<>();
        for (int i = 0; i < COMPASS_POINTS; i++) {
            courses.add(new Course(Kind.COMPASS, 2.0 * Math.PI * i / COMPASS_POINTS, NOWHERE, Optional.empty()));
        }
        sensors.forEach((id, sensor) -> {
            if (sensor.as(CrossingBlind.class).isPresent()) {
                courses.add(new Course(Kind.CROSSING, 0.5 * Math.PI, sensor.position(), Optional.of(id)));
                courses.add(new Course(Kind.CROSSING, -0.5 * Math.PI, sensor.position(), Optional.of(id)));
            }
        });
        if (drone.settings().flightLimits().hover()) {
            courses.add(new Course(Kind.HOVER, 0.0, NOWHERE, Optional.empty()));
        }
        return courses;
    }

    /** A course under power at cruise speed. */
    public Course(Kind kind, double angle, Position reference, Optional<String> sensor) {
        this(kind, angle, reference, sensor, Optional.empty(), OptionalDouble.empty());
    }

    /**
     * The courses of {@link #all} without hovering, at a given speed.
     *
     * @param sensors the sensors, by name
     * @param speed speed of the drone, above 0, m/s
     */
    public static List<Course> at(double speed, Map<String, SensorSettings<?>> sensors, Drone drone) {
        return moving(sensors, drone, Optional.empty(), OptionalDouble.of(speed));
    }

    /**
     * The courses of {@link #all} without hovering, with the motors off and long since cold: the drone descends at its
     * best glide ratio.
     *
     * @param sensors the sensors, by name
     * @throws IllegalArgumentException if the drone cannot glide
     */
    public static List<Course> gliding(Map<String, SensorSettings<?>> sensors, Drone drone) {
        return moving(sensors, drone, Optional.of(GlideDescent.of(drone.settings())), OptionalDouble.empty());
    }

    private static List<Course> moving(
            Map<String, SensorSettings<?>> sensors, Drone drone, Optional<GlideDescent> glide, OptionalDouble speed) {
        return all(sensors, drone).stream()
                .filter(course -> course.kind() != Kind.HOVER)
                .map(course ->
                        new Course(course.kind(), course.angle(), course.reference(), course.sensor(), glide, speed))
                .toList();
    }

    /** This course with another reference point, m. */
    public Course about(Position other) {
        return new Course(kind, angle, other, sensor, glide, speed);
    }

    /** The course towards a point, m. */
    public static Course inbound(Position target) {
        return new Course(Kind.INBOUND, 0.0, target, Optional.empty());
    }

    /**
     * The number of the first course with the same fixed heading as the course with the given number; the given number
     * itself if that course has no fixed heading, or no earlier course has the same one.
     */
    public static int firstOnSameHeading(List<Course> courses, int number) {
        Course course = courses.get(number);
        int first = 0;
        while (first < number && !course.hasFixedHeadingOf(courses.get(first))) {
            first++;
        }
        return first;
    }

    private boolean hasFixedHeadingOf(Course other) {
        return isFixed() && other.isFixed() && angle == other.angle;
    }

    private boolean isFixed() {
        return kind == Kind.COMPASS || kind == Kind.HOVER;
    }

    /** The heading at a position, clockwise from north, rad. */
    public double heading(Position at) {
        return switch (kind) {
            case COMPASS, HOVER -> angle;
            case CROSSING -> bearing(reference, at) + angle;
            case INBOUND -> bearing(at, reference) + angle;
        };
    }

    /** The bearing from one point to another; north where they have the same plan position. */
    private static double bearing(Position from, Position to) {
        return StrictMath.atan2(to.x() - from.x(), to.y() - from.y());
    }

    /**
     * The state of a drone on this course.
     *
     * @param at position of the drone, m
     * @param cruise cruise speed of the drone, m/s
     */
    public FlightState at(Position at, double cruise) {
        double heading = heading(at);
        if (glide.isPresent()) {
            return glide.get().at(at, heading);
        }
        double fast = kind == Kind.HOVER ? 0.0 : speed.orElse(cruise);
        Position velocity = new Position(fast * StrictMath.sin(heading), fast * StrictMath.cos(heading), 0.0);
        return new FlightState(at, velocity, heading);
    }
}
