package org.dronewatch.flight;

import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;

/**
 * The flight of a drone; the speed is a setting of the drone itself. You can implement other flights;
 * {@link org.dronewatch.setting.Kind} explains how scene files can then choose them.
 */
public interface FlightPathSettings {
    /** The shortest leg of a flight, m. */
    double SHORTEST = 0.001;

    /** Maximum number of waypoints of a flight. */
    int MOST_WAYPOINTS = 10_000;

    /**
     * The path for a drone.
     *
     * @param speed cruise speed, m/s, above 0
     * @param acceleration largest acceleration along the path, m/s2, above 0
     * @param ground the ground below; queried only before this method returns
     * @throws IllegalArgumentException when the path follows the ground and there is none
     */
    FlightPath create(double speed, double acceleration, Ground ground);

    /**
     * Whether the drone turns instantly at the corners of its path. Each corner then stands for a rounded turn, for
     * which the legs are assumed to be long enough; the rate of turn is not checked.
     */
    default boolean turnsInstantly() {
        return false;
    }

    /** The compass heading of a displacement, rad clockwise from north; north for a vertical one. */
    private static double headingOf(Position vector) {
        return Math.atan2(vector.x(), vector.y());
    }

    /**
     * A hover at one point.
     *
     * @param position position at which the drone hovers, m
     * @param heading heading of the nose, clockwise from north, rad
     */
    record Hover(Position position, @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double heading)
            implements FlightPathSettings {
        /** Checks the limits. */
        public Hover {
            Limits.check(Hover.class, position, heading);
        }

        /** A hover with the nose to the north. */
        @Defaults("position")
        public static Hover at(Position position) {
            return new Hover(position, 0.0);
        }

        @Override
        public FlightPath create(double speed, double acceleration, Ground ground) {
            FlightState state = new FlightState(position, new Position(0, 0, 0), heading);
            return time -> state;
        }
    }

    /**
     * A straight flight from one point to another, at cruise speed from the beginning; then the drone remains at the
     * end point.
     *
     * @param from position at time 0, m
     * @param to position at the end, m
     */
    record Approach(Position from, Position to) implements FlightPathSettings {
        /** Checks that the two points differ. */
        public Approach {
            Limits.check(Approach.class, from, to);
            Check.atLeast("distance from 'from' to 'to'", from.distance(to), SHORTEST, Quantity.LENGTH);
        }

        @Override
        public FlightPath create(double speed, double acceleration, Ground ground) {
            return new ApproachPath(from, to, headingOf(to.minus(from)), speed);
        }
    }

    /**
     * A level and straight flight towards a point, at cruise speed from the beginning; the drone stops at the point, or
     * at the standoff distance.
     *
     * @param target the point, m
     * @param bearing bearing of the approaching drone from the target, clockwise from north, rad
     * @param height height of the flight above the target, below it if negative, -100,000 to 100,000 m
     * @param distance horizontal distance from the target at time 0, above 0 and at most 100,000 m
     * @param standoff horizontal distance from the target at which the drone stops, 0 or more, less than the distance,
     *     m
     */
    record Inbound(
            Position target,
            @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double bearing,
            @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double height,
            @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) double distance,
            @In(value = Quantity.LENGTH, from = 0, to = In.FARTHEST) @Formerly("nearest") double standoff)
            implements FlightPathSettings {
        /** Checks the limits. */
        public Inbound {
            Limits.check(Inbound.class, target, bearing, height, distance, standoff);
            if (distance - standoff < SHORTEST) {
                throw new IllegalArgumentException("standoff " + standoff + " m must be less than distance " + distance
                        + " m by " + SHORTEST + " m or more");
            }
        }

        /** A flight from the north that ends over the target. */
        @Defaults({"target", "distance"})
        public static Inbound from(Position target, double distance) {
            return new Inbound(target, 0.0, 0.0, distance, 0.0);
        }

        private Position at(double range) {
            return target.plus(new Position(range * Math.sin(bearing), range * Math.cos(bearing), height));
        }

        @Override
        public FlightPath create(double speed, double acceleration, Ground ground) {
            return new Approach(at(distance), at(standoff)).create(speed, acceleration, ground);
        }
    }

    /**
     * A flight from waypoint to waypoint, from rest to rest at no more than the cruise speed; the drone stops at each
     * waypoint at which the path bends, and stays at the last one.
     *
     * @param points 2 to 10,000 waypoints, m; consecutive ones must be 1 mm or more apart
     */
    record Waypoints(List<Position> points) implements FlightPathSettings {
        /** Checks the limits and copies the list. */
        public Waypoints {
            points = List.copyOf(Check.present("points", points));
            if (points.size() < 2 || points.size() > MOST_WAYPOINTS) {
                throw new IllegalArgumentException(
                        "points has " + Counted.of(points.size(), "waypoint") + " but needs 2 to " + MOST_WAYPOINTS);
            }
            for (int i = 1; i < points.size(); i++) {
                Check.atLeast(
                        "distance to waypoint " + i,
                        points.get(i).distance(points.get(i - 1)),
                        SHORTEST,
                        Quantity.LENGTH);
            }
        }

        @Override
        public FlightPath create(double speed, double acceleration, Ground ground) {
            return new WaypointPath(points, speed, acceleration);
        }
    }

    /**
     * A climb under power, followed by a quiet glide with the motors off. The drone stays at the end of the glide.
     *
     * @param from position at time 0, m
     * @param release position at which the motors stop, m
     * @param to end of the glide, m, below the point at which the motors stop; the glide ratio is at most 30
     */
    record Glide(Position from, Position release, Position to) implements FlightPathSettings {
        /** The highest glide ratio, above those that the best gliders of a drone's size reach. */
        private static final double FLATTEST = 30.0;

        /** Checks the limits. */
        public Glide {
            Limits.check(Glide.class, from, release, to);
            Check.atLeast("distance from 'from' to 'release'", from.distance(release), SHORTEST, Quantity.LENGTH);
            double drop =
                    Check.atLeast("height of 'release' above 'to'", release.z() - to.z(), SHORTEST, Quantity.LENGTH);
            double ratio = Math.hypot(to.x() - release.x(), to.y() - release.y()) / drop;
            if (ratio > FLATTEST) {
                throw new IllegalArgumentException(
                        "glide ratio " + (float) ratio + " from 'release' to 'to' must be at most " + FLATTEST);
            }
        }

        @Override
        public FlightPath create(double speed, double acceleration, Ground ground) {
            FlightPath climb = new Approach(from, release).create(speed, acceleration, ground);
            FlightPath glide = new Approach(release, to).create(speed, acceleration, ground);
            double climbing = from.distance(release) / speed;
            return time -> {
                FlightState state = time < climbing ? climb.at(time) : glide.at(time - climbing);
                return time < climbing
                        ? state
                        : new FlightState(
                                state.position(),
                                state.velocity(),
                                state.heading(),
                                OptionalDouble.of(time - climbing));
            };
        }
    }

    /**
     * A flight in a level circle, clockwise as seen from above, nose first and at cruise speed.
     *
     * @param centre centre of the circle, m
     * @param radius radius of the circle, 0.1 to 100,000 m
     * @param bearing bearing of the drone from the centre at time 0, clockwise from north, rad
     */
    record Orbit(
            Position centre,
            @In(value = Quantity.LENGTH, from = 0.1, to = In.FARTHEST) double radius,
            @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double bearing)
            implements FlightPathSettings {
        /** Checks the limits. */
        public Orbit {
            Limits.check(Orbit.class, centre, radius, bearing);
        }

        /** A circle that begins at its northernmost point. */
        @Defaults({"centre", "radius"})
        public static Orbit about(Position centre, double radius) {
            return new Orbit(centre, radius, 0.0);
        }

        @Override
        public FlightPath create(double speed, double acceleration, Ground ground) {
            return time -> {
                double now = bearing + speed / radius * time;
                Position position = centre.plus(new Position(radius * Math.sin(now), radius * Math.cos(now), 0.0));
                Position velocity = new Position(speed * Math.cos(now), -speed * Math.sin(now), 0.0);
                return new FlightState(position, velocity, now + 0.5 * Math.PI);
            };
        }
    }
}
