package org.dronewatch.flight;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;

/**
 * A flight along straight legs, each at its own constant speed, without stopping between them, as the search for the
 * weakest route assumes. The drone turns instantly and flies nose first; on a vertical leg, its heading does not
 * change. It stays at the end of the last leg.
 *
 * @param from position at time 0, m
 * @param legs 1 to 10,000 legs, each 1 mm or longer
 * @param delay time for which the drone waits at its starting point before the first leg, with its nose pointing along
 *     that leg and its motors running, 0 to 3600 s; 0 by default
 */
public record RouteFlight(
        Position from, List<RouteLeg> legs, @In(value = Quantity.DURATION, from = 0, to = 3600) double delay)
        implements FlightPathSettings {
    /** Horizontal distances shorter than this are taken to have no direction, m. */
    private static final double VERTICAL = 1e-9;

    /**
     * Checks the limits and copies the list.
     *
     * @throws IllegalArgumentException if there are too few or too many legs, one is too short, or a glide rises
     */
    public RouteFlight {
        legs = List.copyOf(Check.present("legs", legs));
        Limits.check(RouteFlight.class, from, legs, delay);
        if (legs.isEmpty() || legs.size() > MOST_WAYPOINTS) {
            throw new IllegalArgumentException("legs has " + legs.size() + " legs but needs 1 to " + MOST_WAYPOINTS);
        }
        Position at = from;
        for (int i = 0; i < legs.size(); i++) {
            Position to = legs.get(i).to();
            Check.atLeast("length of leg " + (i + 1), at.distance(to), SHORTEST, Quantity.LENGTH);
            if (!legs.get(i).powered() && to.z() >= at.z()) {
                throw new IllegalArgumentException("leg " + (i + 1) + " without power ends at " + (float) to.z()
                        + " m: it must end below its beginning at " + (float) at.z() + " m");
            }
            at = to;
        }
    }

    /** A flight that begins at once. */
    @Defaults({"from", "legs"})
    public static RouteFlight of(Position from, List<RouteLeg> legs) {
        return new RouteFlight(from, legs, 0.0);
    }

    @Override
    public boolean turnsInstantly() {
        return true;
    }

    /** This flight with another delay, s. */
    public RouteFlight withDelay(double seconds) {
        return new RouteFlight(from, legs, seconds);
    }

    @Override
    public FlightPath create(double speed, double acceleration, Ground ground) {
        List<Leg> flown = new ArrayList<>();
        Position at = from;
        double time = delay;
        double heading = 0.0;
        OptionalDouble stopped = OptionalDouble.empty();
        for (RouteLeg leg : legs) {
            Position vector = leg.to().minus(at);
            double fast = leg.speed().orElse(speed);
            boolean isVertical = Math.hypot(vector.x(), vector.y()) < VERTICAL;
            heading = isVertical ? heading : StrictMath.atan2(vector.x(), vector.y());
            stopped = leg.powered() ? OptionalDouble.empty() : OptionalDouble.of(stopped.orElse(time));
            if (flown.isEmpty() && delay > 0.0) {
                flown.add(leg(0.0, at, new Position(0, 0, 0), heading, OptionalDouble.empty()));
            }
            flown.add(leg(time, at, vector.times(fast / vector.length()), heading, stopped));
            time += vector.length() / fast;
            at = leg.to();
        }
        flown.add(leg(time, at, new Position(0, 0, 0), heading, stopped));
        return new RecordedFlight(flown);
    }

    private static Leg leg(double time, Position at, Position velocity, double heading, OptionalDouble stopped) {
        OptionalDouble gliding =
                stopped.isPresent() ? OptionalDouble.of(time - stopped.getAsDouble()) : OptionalDouble.empty();
        return new Leg(time, new FlightState(at, velocity, heading, gliding));
    }

    /**
     * The time at which the drone arrives at the end, s since the start of the run.
     *
     * @param speed cruise speed, m/s
     */
    public double duration(double speed) {
        Position at = from;
        double time = delay;
        for (RouteLeg leg : legs) {
            time += at.distance(leg.to()) / leg.speed().orElse(speed);
            at = leg.to();
        }
        return time;
    }
}
