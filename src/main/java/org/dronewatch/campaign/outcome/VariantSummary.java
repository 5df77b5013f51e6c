package org.dronewatch.campaign.outcome;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.dronewatch.statistics.Proportion;

/** The results of all cases of one variant. Results are added one by one. For use by one thread. */
public final class VariantSummary {
    /** The number of sectors into which bearings are divided, the first centred on north. */
    public static final int SECTORS = 8;

    private static final double TURN = 2.0 * Math.PI;

    private final Map<Outcome, int[]> outcomes = new EnumMap<>(Outcome.class);
    private final List<Map<Outcome, int[]>> sectors = new ArrayList<>();
    private final Map<String, Map<Outcome, int[]>> drones = new LinkedHashMap<>();
    private final Map<String, Integer> firstSensors = new TreeMap<>();
    private final Measures ranges = new Measures();
    private final Measures warnings = new Measures();
    private final FailedCases failures = new FailedCases();
    private int cases;
    private int failed;
    private int cutShort;

    VariantSummary() {
        for (int i = 0; i < SECTORS; i++) {
            sectors.add(new EnumMap<>(Outcome.class));
        }
    }

    void add(CaseResult result) {
        cases++;
        if (result.isFailed()) {
            failed++;
            failures.add(result);
            return;
        }
        cutShort += result.cutShort() ? 1 : 0;
        count(outcomes, result, outcome -> outcome.isMetBy(result));
        if (result.bearing().isPresent()) {
            count(sectors.get(sector(result.bearing().getAsDouble())), result, outcome -> outcome.isMetBy(result));
        }
        result.drones().forEach((name, drone) -> {
            Map<Outcome, int[]> its = drones.computeIfAbsent(name, unseen -> new EnumMap<>(Outcome.class));
            count(its, result, drone::has);
        });
        result.firstSensor().ifPresent(sensor -> firstSensors.merge(sensor, 1, Integer::sum));
        ranges.add(result.range());
        warnings.add(result.warning());
    }

    private static void count(Map<Outcome, int[]> counts, CaseResult result, Predicate<Outcome> isMet) {
        for (Outcome outcome : Outcome.values()) {
            if (outcome.isKnown(result)) {
                int[] count = counts.computeIfAbsent(outcome, unseen -> new int[2]);
                count[0] += isMet.test(outcome) ? 1 : 0;
                count[1]++;
            }
        }
    }

    /** The number of the sector of a bearing, clockwise from north, rad; sector 0 is centred on north. */
    public static int sector(double bearing) {
        return Math.floorMod((int) Math.floor(bearing / TURN * SECTORS + 0.5), SECTORS);
    }

    /** The number of all cases, including those that failed. */
    public int cases() {
        return cases;
    }

    /** The number of cases that could not be run; they are not included in any other result. */
    public int failed() {
        return failed;
    }

    /** Why cases failed, in the order in which the reasons occurred. */
    public List<FailedCases.Reason> failures() {
        return failures.reasons();
    }

    /**
     * The number of cases whose run ended while a drone for which there was no alert was still coming closer to what is
     * protected. These cases count with the outcome that they had, although a longer run might have had another.
     */
    public int cutShort() {
        return cutShort;
    }

    /** The proportion of cases with an outcome, among those in which it is known; empty if there are none. */
    public Optional<Proportion> proportion(Outcome outcome) {
        return proportion(outcomes, outcome);
    }

    /**
     * The proportion of attacks with an outcome, among those that begin in a sector, given by its number, and for which
     * the outcome is known; empty if there are none.
     */
    public Optional<Proportion> proportion(Outcome outcome, int sector) {
        return proportion(sectors.get(sector), outcome);
    }

    private static Optional<Proportion> proportion(Map<Outcome, int[]> counts, Outcome outcome) {
        return Optional.ofNullable(counts.get(outcome)).map(count -> new Proportion(count[0], count[1]));
    }

    /** The attacking drones, in the order in which the scene lists them. */
    public Set<String> drones() {
        return Collections.unmodifiableSet(drones.keySet());
    }

    /**
     * The proportion of cases in which an attacking drone, given by its name, has an outcome, among those in which the
     * drone takes part and the outcome is known for it; empty if there are none.
     */
    public Optional<Proportion> proportion(Outcome outcome, String drone) {
        return proportion(drones.getOrDefault(drone, Map.of()), outcome);
    }

    /**
     * The number of cases in which each sensor was the first to detect a drone, by name of the sensor, in alphabetical
     * order.
     */
    public Map<String, Integer> firstSensors() {
        return Collections.unmodifiableMap(firstSensors);
    }

    /** The range of the first detection in each case, m. */
    public Measures ranges() {
        return ranges;
    }

    /** The warning time in each case, s. */
    public Measures warnings() {
        return warnings;
    }
}
