package org.dronewatch.flight;

import java.util.List;

/** A flight of known legs, of which the last never ends. Immutable. */
record RecordedFlight(List<Leg> legs) implements FlownPath {
    RecordedFlight {
        legs = List.copyOf(legs);
    }

    @Override
    public FlightState at(double time) {
        return Leg.at(legs, time);
    }
}
