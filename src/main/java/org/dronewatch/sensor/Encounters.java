package org.dronewatch.sensor;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** A sensor's encounters with drones before one of its looks. Immutable. */
public final class Encounters {
    /** No encounters yet. */
    public static final Encounters NONE = new Encounters(Map.of());

    private final Map<String, Met> latest;

    /**
     * The latest encounter with a drone.
     *
     * @param visible when the drone could last be seen, seconds since the start of the run
     */
    private record Met(Encounter encounter, double visible) {
        /** The later of the two; both combined if they come from the same look. */
        Met latest(Met other) {
            return other.visible > visible ? other : new Met(encounter.or(other.encounter), visible);
        }
    }

    private Encounters(Map<String, Met> latest) {
        this.latest = latest;
    }

    /**
     * The encounter to which a look at a drone belongs: the latest one, unless the drone has been out of sight for too
     * long since.
     *
     * @param drone name of the drone
     * @param time time of the look, seconds since the start of the run
     * @param rate looks per second, Hz
     */
    Encounter with(String drone, double time, double rate) {
        Met met = latest.get(drone);
        if (met == null) {
            return Encounter.FIRST;
        }
        return time - met.visible() > Encounter.gap(rate) ? met.encounter().next() : met.encounter();
    }

    /**
     * The encounters after a look.
     *
     * @param look the look, with the encounters before it
     * @param rate looks per second, Hz
     * @param observations observations of the look
     */
    public static Encounters after(Look look, double rate, List<Observation> observations) {
        Map<String, Met> next = new HashMap<>(look.encounters().latest);
        for (Observation seen : observations) {
            if (!seen.isFalse() && seen.probability() > 0.0) {
                Encounter now = look.encounter(seen.drone(), rate).with(seen);
                next.merge(seen.drone(), new Met(now, look.time()), Met::latest);
            }
        }
        return new Encounters(next);
    }
}
