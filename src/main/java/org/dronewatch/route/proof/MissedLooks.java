package org.dronewatch.route.proof;

import java.util.ArrayList;
import java.util.Comparator;
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
    private MissedLooks() {}

    /**
     * The probability that none of them does.
     *
     * @param looks in order of time
     */
    static double probability(List<ScheduledLook> looks, SensorSettings<?> sensor) {
        if (sensor.chance() == Chance.PER_LOOK) {
            return looks.stream()
                    .mapToDouble(look -> 1.0 - look.probability())
                    .reduce(1.0, (one, other) -> one * other);
        }
        double missed = 1.0;
        for (List<ScheduledLook> encounter : encounters(looks, sensor).values()) {
            missed *= ofEncounter(encounter, sensor.rate());
        }
        return missed;
    }

    private static Map<Long, List<ScheduledLook>> encounters(List<ScheduledLook> looks, SensorSettings<?> sensor) {
        Map<Long, List<ScheduledLook>> encounters = new TreeMap<>();
        Encounters before = Encounters.NONE;
        for (ScheduledLook scheduled : looks) {
            Look look = scheduled.look().withEncounters(before);
            Encounter now = look.encounter(scheduled.drone().id(), sensor.rate());
            if (scheduled.counts()) {
                encounters
                        .computeIfAbsent(now.index(), index -> new ArrayList<>())
                        .add(scheduled);
            }
            before = Encounters.after(
                    look, sensor.rate(), List.of(observation(scheduled, Double.POSITIVE_INFINITY, sensor)));
        }
        return encounters;
    }

    /** What such a look of an observer records, as far as the looks that follow depend on it. */
    static Observation observation(ScheduledLook look, double threshold, SensorSettings<?> sensor) {
        Reading reading = new Reading(look.probability(), threshold, "");
        return new Observation(look.look().id(sensor.kind()), look.drone().id(), 0.0, reading)
                .withFigures(Map.of(Observation.PROBABILITY, look.probability()));
    }

    /**
     * The mean over the number u that the observer draws, from 0 to 1, of the probability that the search fails in all
     * looks with {@code p >= u}. Between two neighbouring probabilities, it is the same for all u.
     */
    private static double ofEncounter(List<ScheduledLook> looks, double rate) {
        List<ScheduledLook> easiest = looks.stream()
                .sorted(Comparator.comparingDouble(look -> -look.probability()))
                .toList();
        double missed = 0.0;
        double above = 1.0;
        double exponent = 0.0;
        for (ScheduledLook look : easiest) {
            missed += (above - look.probability()) * Math.exp(-exponent);
            above = look.probability();
            // Nobody has searched before the run begins.
            exponent += look.probability() * Math.min(1.0 / rate, look.time()) / Encounter.SEARCH_TIME;
        }
        return missed + above * Math.exp(-exponent);
    }
}
