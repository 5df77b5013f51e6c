package org.dronewatch.sensor;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A sensor's encounters with drones, as they are before one of its looks. Immutable: looks lead from one to the next.
 */
public final class Encounters {
    /** Nothing has been encountered yet. */
    public static final Encounters NONE = new Encounters(Map.of());

    private final Map<String, Met> latest;

    /**
     * The latest encounter with a drone.
     *
     * @param visible when the drone could last be seen, seconds since the start of the run
     */
    private record Met(Encounter encounter, double visible) {}

    private Encounters(Map<String, Met> latest) {
        this.latest = latest;
    }

    /**
     * The encounter to which a look at a drone belongs: the latest one, unless the drone has been out of sight for too
     * long since.
     *
     * @param drone name of the drone
     * @param time of the look, seconds since the start of the run
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
     * @param look what it was, with the encounters before it
     * @param rate looks per second, Hz
     * @param observations of the look
     */
    public static Encounters after(Look look, double rate, List<Observation> observations) {
        Map<String, Boolean> visible = new LinkedHashMap<>();
        for (Observation seen : observations) {
            if (!seen.isFalse() && seen.probability() > 0.0) {
                visible.merge(seen.drone(), seen.isDetected(), Boolean::logicalOr);
            }
        }
        if (visible.isEmpty()) {
            return look.encounters();
        }
        Map<String, Met> next = new HashMap<>(look.encounters().latest);
        visible.forEach((drone, isDetected) -> {
            Encounter before = look.encounter(drone, rate);
            Encounter now = new Encounter(before.index(), before.isFound() || isDetected);
            next.put(drone, new Met(now, look.time()));
        });
        return new Encounters(next);
    }
}
