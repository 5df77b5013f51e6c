package org.dronewatch.flight;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * A path through waypoints with limited speed and acceleration. Collinear waypoints form one leg; each leg is flown
 * from rest to rest: the drone accelerates, cruises and decelerates.
 */
final class WaypointPath implements FlightPath {
    /** Below this change of direction (a metre in a hundred kilometres) two legs count as one. */
    private static final double STRAIGHT = 1e-5;

    private final List<Straight> straights = new ArrayList<>();
    private final double speed;

    WaypointPath(List<Position> points, double speed, double acceleration) {
        this.speed = speed;
        Position start = points.get(0);
        double time = 0.0;
        for (int i = 1; i < points.size(); i++) {
            boolean last = i == points.size() - 1;
            if (last || bends(points.get(i - 1), points.get(i), points.get(i + 1))) {
                Straight straight = new Straight(start, points.get(i), time, speed, acceleration);
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

    @Override
    public OptionalDouble topSpeed() {
        return OptionalDouble.of(speed);
    }

    /** One straight leg, flown from rest to rest. */
    private static final class Straight {
        private final Position from;
        private final Position direction;
        private final RestToRest motion;
        private final double startTime;
        private final double duration;
        private final double heading;

        Straight(Position from, Position to, double startTime, double speed, double acceleration) {
            double length = from.distance(to);
            this.from = from;
            this.direction = to.minus(from).times(1.0 / length);
            this.motion = new RestToRest(length, speed, acceleration);
            this.startTime = startTime;
            this.duration = motion.duration();
            this.heading = Math.atan2(direction.x(), direction.y());
        }

        FlightState at(double time) {
            return new FlightState(
                    from.plus(direction.times(motion.distance(time))), direction.times(motion.speed(time)), heading);
        }
    }
}
