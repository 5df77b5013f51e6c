package org.dronewatch.flight;

import java.util.List;

/** A flight that is made of legs. */
public interface FlownPath extends FlightPath {

    /** The legs that have begun so far, in order of time; at least one, of which the first begins at time 0. */
    List<Leg> legs();
}
