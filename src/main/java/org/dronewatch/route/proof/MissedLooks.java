package org.dronewatch.route.proof;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Encounter;
import org.dronewatch.sensor.Encounters;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.SensorSettings;

/** The probability that none of the looks of one sensor detects a drone on its route. */
final class MissedLooks {
    /** Whether an observer sees a drone that waits until its route begins, as it does in a run. */
    enum Wait {
        /**
         * It is not seen, as if it came from elsewhere; its visibility only decides to which encounter a look belongs.
         */
        UNSEEN,
        /** The observer searches for it, as in a run. */
        SEEN
    }

    private MissedLooks() {}

    /**
     * The probability that none of the looks of a sensor detects the drone.
     *
     * @param looks the looks, in order of time
     */
    static double probability(List<ScheduledLook> looks, SensorSettings<?> sensor, Wait wait) {
        double[] after = afterEach(looks, sensor, wait);
        return after.length == 0 ? 1.0 : after[after.length - 1];
    }

    /**
     * For each look, the probability that neither it nor any before it detects the drone.
     *
     * @param looks the looks, in order of time
     * @param wait whether an observer sees the drone while it waits; no difference for other sensors
     */
    static double[] afterEach(List<ScheduledLook> looks, SensorSettings<?> sensor, Wait wait) {
        double[] after = new double[looks.size()];
        double missed = 1.0;
        int done = 0;
        if (sensor.chance() == Chance.PER_LOOK) {
            for (ScheduledLook look : looks) {
                missed *= 1.0 - look.probability();
                after[done++] = missed;
            }
            return after;
        }
        for (List<ScheduledLook> encounter : encounters(looks, sensor)) {
            EncounterMisses misses = new EncounterMisses(encounter, sensor.rate());
            double before = missed;
            for (ScheduledLook look : encounter) {
                if (look.probability() > 0.0 && look.counts()) {
                    missed = Math.min(missed, before * misses.after(look));
                } else if (look.probability() > 0.0 && wait == Wait.SEEN) {
                    misses.takeBefore(look);
                }
                after[done++] = missed;
            }
        }
        return after;
    }

    /** The looks of each encounter in turn. */
    private static Collection<List<ScheduledLook>> encounters(List<ScheduledLook> looks, SensorSettings<?> sensor) {
        Map<Long, List<ScheduledLook>> encounters = new TreeMap<>();
        Encounters before = Encounters.NONE;
        for (ScheduledLook scheduled : looks) {
            Look look = scheduled.look().withEncounters(before);
            Encounter now = look.encounter(scheduled.drone().id(), sensor.rate());
            encounters.computeIfAbsent(now.index(), index -> new ArrayList<>()).add(scheduled);
            before = Encounters.after(
                    look, sensor.rate(), List.of(observation(scheduled, Double.POSITIVE_INFINITY, sensor)));
        }
        return encounters.values();
    }

    /** What a look of an observer records: only the part on which the looks that follow depend. */
    static Observation observation(ScheduledLook look, double threshold, SensorSettings<?> sensor) {
        Reading reading = new Reading(look.probability(), threshold, "");
        return new Observation(look.look().id(sensor.kind()), look.drone().id(), 0.0, reading)
                .withFigures(Map.of(Observation.PROBABILITY, look.probability()));
    }
}
