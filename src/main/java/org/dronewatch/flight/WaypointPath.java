package org.dronewatch.flight;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;

/**
 * A path through waypoints with limited speed and acceleration. Collinear waypoints form one leg; each leg is flown
 * from rest to rest: accelerate, cruise, decelerate.
 */
final class WaypointPath implements FlightPath {
    /** Below this change of direction (a metre in a hundred kilometres) two legs count as one. */
    private static final double STRAIGHT = 1e-5;

    private final List<Straight> straights = new ArrayList<>();
    private final double acceleration;

    WaypointPath(List<Position> points, double speed, double acceleration) {
        this.acceleration = acceleration;
        Position start = points.get(0);
        double time = 0.0;
        for (int i = 1; i < points.size(); i++) {
            boolean last = i == points.size() - 1;
            if (last || bends(points.get(i - 1), points.get(i), points.get(i + 1))) {
                Straight straight = new Straight(start, points.get(i), time, speed);
                straights.add(straight);
                time = straight.startTime + straight.duration;
                start = points.get(i);
            }
        }
    }

    private static boolean bends(Position before, Position here, Position after) {
        Position in = here.minus(before);
        Position out = after.minus(here);
        return in.unit().distance(out.unit()) > STRAIGHT;
    }

    @Override
    public FlightState at(double time) {
        for (Straight straight : straights) {
            if (time < straight.startTime + straight.duration) {
                return straight.at(time - straight.startTime);
            }
        }
        Straight last = straights.get(straights.size() - 1);
        return last.at(last.duration);
    }

    /** One straight leg, flown from rest to rest. */
    private final class Straight {
        private final Position from;
        private final Position direction;
        private final double length;
        private final double startTime;
        private final double topSpeed;
        private final double rampTime;
        private final double duration;
        private final double heading;

        Straight(Position from, Position to, double startTime, double speed) {
            this.from = from;
            this.length = from.distance(to);
            this.direction = to.minus(from).times(1.0 / length);
            this.startTime = startTime;
            // A short leg is over before the cruise speed is reached: v^2 = a * length in its middle.
            this.topSpeed = Math.min(speed, Math.sqrt(acceleration * length));
            this.rampTime = topSpeed / acceleration;
            this.duration = length / topSpeed + rampTime;
            this.heading = Math.atan2(direction.x(), direction.y());
        }

        FlightState at(double time) {
            double left = duration - time;
            if (left <= 0.0) {
                return state(length, 0.0);
            }
            if (time < rampTime) {
                return state(0.5 * acceleration * time * time, acceleration * time);
            }
            if (left < rampTime) {
                return state(length - 0.5 * acceleration * left * left, acceleration * left);
            }
            return state(topSpeed * (time - 0.5 * rampTime), topSpeed);
        }

        private FlightState state(double flown, double speed) {
            return new FlightState(from.plus(direction.times(flown)), direction.times(speed), heading);
        }
    }
}
