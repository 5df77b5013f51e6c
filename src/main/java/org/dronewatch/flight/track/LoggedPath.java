package org.dronewatch.flight.track;

import java.util.List;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.FlownPath;
import org.dronewatch.flight.Leg;

/** A flight between the points of a log. Immutable. */
record LoggedPath(List<Leg> legs) implements FlownPath {
    LoggedPath {
        legs = List.copyOf(legs);
    }

    @Override
    public FlightState at(double time) {
        return Leg.at(legs, time);
    }
}
