package org.dronewatch.flight.mission;

import java.util.List;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.RestToRest;
import org.dronewatch.geometry.Position;

/**
 * A path of legs, each flown from rest to rest, with waits between them. The drone stays at the end.
 *
 * @param legs the legs, in order of time
 * @param start position of the drone if there are no legs, m
 * @param heading heading of the nose if there are no legs, rad
 */
record MissionPath(List<Leg> legs, Position start, double heading) implements FlightPath {
    MissionPath {
        legs = List.copyOf(legs);
    }

    @Override
    public FlightState at(double time) {
        if (legs.isEmpty()) {
            return new FlightState(start, new Position(0, 0, 0), heading);
        }
        int low = 0;
        int high = legs.size() - 1;
        while (low < high) {
            int middle = (low + high + 1) >>> 1;
            if (legs.get(middle).begin <= time) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return legs.get(low).at(Math.max(0.0, time - legs.get(low).begin));
    }

    /**
     * One leg.
     *
     * @param begin time at which the leg begins, s
     */
    record Leg(Course course, double begin, RestToRest motion, double heading) {

        /** A leg that is flown nose first; on a vertical leg, the heading does not change. */
        static Leg of(Course course, double begin, double speed, double acceleration, double former) {
            return new Leg(course, begin, new RestToRest(course.length(), speed, acceleration), course.heading(former));
        }

        double end() {
            return begin + motion.duration();
        }

        FlightState at(double since) {
            double flown = motion.distance(since);
            int piece = course.piece(flown);
            return new FlightState(
                    course.at(piece, flown), course.direction(piece).times(motion.speed(since)), heading);
        }
    }

    /**
     * The path of a leg: a straight line, a nearly straight line through several waypoints, or a line over the surface
     * that is straight in plan view.
     */
    static final class Course {
        private final Position[] points;
        private final double[] along;

        /** A path through points, m; successive points differ. */
        Course(Position[] points) {
            this.points = points.clone();
            this.along = new double[points.length];
            for (int i = 1; i < points.length; i++) {
                along[i] = along[i - 1] + points[i].distance(points[i - 1]);
            }
        }

        double length() {
            return along[along.length - 1];
        }

        /** The piece in which a distance along the path lies. */
        int piece(double distance) {
            int low = 0;
            int high = points.length - 2;
            while (low < high) {
                int middle = (low + high + 1) >>> 1;
                if (along[middle] <= distance) {
                    low = middle;
                } else {
                    high = middle - 1;
                }
            }
            return low;
        }

        Position direction(int piece) {
            return points[piece + 1].minus(points[piece]).times(1.0 / (along[piece + 1] - along[piece]));
        }

        Position at(int piece, double distance) {
            return distance >= length()
                    ? points[points.length - 1]
                    : points[piece].plus(direction(piece).times(distance - along[piece]));
        }

        /** The greatest rise for each metre of the path, upwards (1) or downwards (-1); 0 if there is none. */
        double steepest(double sign) {
            double steepest = 0.0;
            for (int i = 0; i < points.length - 1; i++) {
                steepest = Math.max(steepest, sign * direction(i).z());
            }
            return steepest;
        }

        double heading(double former) {
            Position whole = points[points.length - 1].minus(points[0]);
            return Math.hypot(whole.x(), whole.y()) > 1e-3 ? Math.atan2(whole.x(), whole.y()) : former;
        }
    }
}
