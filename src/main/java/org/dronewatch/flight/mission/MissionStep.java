package org.dronewatch.flight.mission;

import java.util.Optional;
import org.dronewatch.geo.EarthPoint;

/** A step of a mission: an action of the drone that one item of the mission commands. */
sealed interface MissionStep {
    /** The location of the item in the file, for messages. */
    String where();

    /** The level from which a height is measured. */
    enum Frame {
        /** Sea level. */
        SEA,
        /** The ground at the launch position. */
        HOME,
        /** The surface below the place. */
        SURFACE
    }

    /**
     * A height, m.
     *
     * @param frame the level from which it is measured
     */
    record Height(Frame frame, double metres) {}

    /** Climbs from the ground at home, and then flies on to a place, if one is given. */
    record TakeOff(String where, Optional<EarthPoint> place, Height height) implements MissionStep {}

    /** Flies straight to a place, and waits there for some seconds. */
    record FlyTo(String where, EarthPoint place, Height height, double hold) implements MissionStep {}

    /** Flies to above a place, if one is given, and descends to the surface. */
    record Land(String where, Optional<EarthPoint> place) implements MissionStep {}

    /** Flies in a straight line down to the surface at a place, as a fixed-wing aircraft lands. */
    record TouchDown(String where, EarthPoint place) implements MissionStep {}

    /** Flies to above home at its present height, and lands there. */
    record Return(String where) implements MissionStep {}

    /** Waits for some seconds. */
    record Wait(String where, double seconds) implements MissionStep {}

    /** Flies at another speed from now on, m/s. */
    record Speed(String where, double speed) implements MissionStep {}

    /** Stays where it is until the end of the run. */
    record Stay(String where) implements MissionStep {}
}
