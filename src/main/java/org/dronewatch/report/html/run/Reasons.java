package org.dronewatch.report.html.run;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.analysis.survey.LineOfSight;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.report.html.BlockerWords;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.Pointings;
import org.dronewatch.run.Sightline;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.SensorSettings;

/**
 * Explains why a sensor did not detect a drone, and for what fraction of the time: out of range, out of its field of
 * view, hidden, and by which model, of a kind that the sensor cannot detect, or with too weak a signal.
 */
final class Reasons {
    /** Number of instants of a run that are examined, besides its start. */
    static final int MOMENTS = 400;

    /** A sensor that misses a drone for less than this fraction of the run detects it throughout. */
    private static final double LEAST_MISSED = 0.01;

    /** Percentages of at least this are rounded to 100, which represents the whole time. */
    private static final double MOST_ROUNDED = 99.5;

    private final SceneSettings settings;
    private final Stage stage;
    private final Pointings pointings;
    private final LineOfSight sight;
    private final Map<String, Assessor> assessors = new HashMap<>();
    private final List<Map<String, Drone>> moments = new ArrayList<>();
    private final double step;

    /**
     * The reasons in a run.
     *
     * @param simulated simulated time, s
     */
    Reasons(SceneSettings settings, Stage stage, Pointings pointings, double simulated) {
        this.settings = settings;
        this.stage = stage;
        this.pointings = pointings;
        this.sight = new LineOfSight(stage);
        this.step = simulated / MOMENTS;
        for (int i = 0; i <= MOMENTS; i++) {
            Map<String, Drone> drones = new HashMap<>();
            stage.dronesAt(i * step).forEach(drone -> drones.put(drone.id(), drone));
            moments.add(drones);
        }
    }

    /**
     * Why a sensor missed some drones, in words, the most frequent reason first.
     *
     * @param drones that the sensor did not detect, at least one
     * @param best the best look at any of them
     */
    String of(String sensor, List<String> drones, Optional<BestLook> best) {
        SensorSettings<?> missing = settings.sensors().get(sensor);
        Fractions fractions = fractions(sensor, drones, weakness(missing, best), 0.0, (drone, time) -> true);
        boolean measured =
                fractions.weak() > 0 && best.filter(Reasons::isReading).isPresent();
        String distance = measured ? "" : format("; the closest approach was %.0f m", fractions.nearest());
        boolean quiet = !Sightline.hasFieldOfView(missing) && fractions.weak() > 0 && fractions.gliding() > 0;
        return fractions.inWords("always %s")
                + distance
                + (quiet ? "; motors off " + percent(fractions.gliding(), fractions.all()) + " of the time" : "");
    }

    /** Why a sensor does not detect some drones again that it has lost, in words. */
    String afterLoss(String sensor, List<String> drones, double time) {
        return fractions(
                        sensor,
                        drones,
                        settings.sensors().get(sensor).description().weakness(),
                        time,
                        (drone, later) -> true)
                .inWords("%s from then on");
    }

    /**
     * For how much of the run a sensor does not detect some drones that it detects at some time, and why; empty if that
     * is less than one percent.
     *
     * @param detected when the sensor detects which drone
     */
    Optional<Undetected> whileUndetected(String sensor, List<String> drones, DetectionIntervals detected) {
        Fractions fractions = fractions(
                sensor,
                drones,
                settings.sensors().get(sensor).description().weakness(),
                0.0,
                (drone, time) -> !detected.isDetected(sensor, drone, time));
        int missed = fractions.missed();
        return missed < LEAST_MISSED * fractions.all()
                ? Optional.empty()
                : Optional.of(new Undetected(percent(missed, fractions.all()), fractions.inWords("%s")));
    }

    /**
     * The part of a run in which a sensor does not detect a drone.
     *
     * @param part its length, {@code 78 %}
     * @param reason why it does not; several reasons with the part of the whole run for which each holds
     */
    record Undetected(String part, String reason) {}

    /** Selects times at which a drone is missed, s since the start. */
    @FunctionalInterface
    private interface Missed {
        boolean at(String drone, double time);
    }

    /**
     * The number of instants of a run at which each reason held.
     *
     * @param all the number of instants, those at which the drone was detected included
     */
    private record Fractions(Map<String, Integer> counts, int all, int weak, double nearest, int gliding) {
        int missed() {
            return counts.values().stream().mapToInt(Integer::intValue).sum();
        }

        /** The reasons in words; a single one by a pattern that says when it held. */
        String inWords(String throughout) {
            List<Map.Entry<String, Integer>> sorted = new ArrayList<>(counts.entrySet());
            sorted.sort(Map.Entry.comparingByValue(Comparator.reverseOrder()));
            if (sorted.size() == 1) {
                return format(throughout, sorted.get(0).getKey());
            }
            return sorted.stream()
                    .map(one -> percent(one.getValue(), all) + " of the time: " + one.getKey())
                    .collect(Collectors.joining("; "));
        }
    }

    private Fractions fractions(String sensor, List<String> drones, String weak, double from, Missed missed) {
        SensorSettings<?> missing = settings.sensors().get(sensor);
        Assessor assessor = assessors.computeIfAbsent(sensor, id -> new Assessor(id, missing, stage.world()));
        Map<String, Integer> counts = new LinkedHashMap<>();
        Map<String, Evidence> evidence = new HashMap<>();
        double nearest = Double.POSITIVE_INFINITY;
        int gliding = 0;
        int all = 0;
        int first = (int) Math.min(MOMENTS, Math.ceil(from / step));
        for (int i = first; i <= MOMENTS; i++) {
            Optional<Pointing> pointing = pointings.at(sensor, i * step);
            for (String drone : drones) {
                all++;
                if (!missed.at(drone, i * step)) {
                    continue;
                }
                Drone flying = moments.get(i).get(drone);
                Position position = flying.origin();
                nearest = Math.min(nearest, position.distance(missing.position()));
                gliding += flying.isPowered() ? 0 : 1;
                Explanation explanation = assessor.explainMiss(flying, pointing);
                String reason = CauseWords.of(explanation, flying, weak);
                Evidence shown = evidence.computeIfAbsent(reason, one -> new Evidence());
                shown.add(explanation);
                if (explanation.cause().isHidden()) {
                    building(missing.position(), position).ifPresent(shown::addBuilding);
                }
                counts.merge(reason, 1, Integer::sum);
            }
        }
        return new Fractions(explained(counts, evidence), all, counts.getOrDefault(weak, 0), nearest, gliding);
    }

    /** The name of the building of the map that blocks a line of sight first; empty if none does. */
    private Optional<String> building(Position from, Position to) {
        return sight.between(from, to)
                .map(LineOfSight.Blocked::blocker)
                .filter(blocker -> blocker.building().isPresent())
                .map(BlockerWords::name);
    }

    /** Adds to each reason the buildings and materials that hid the drone, or the limits that it violated. */
    private static Map<String, Integer> explained(Map<String, Integer> counts, Map<String, Evidence> evidence) {
        Map<String, Integer> explained = new LinkedHashMap<>();
        counts.forEach(
                (reason, count) -> explained.put(reason + evidence.get(reason).inWords(), count));
        return explained;
    }

    private static boolean isReading(BestLook look) {
        return Double.isFinite(look.value()) && look.value() != 0.0;
    }

    private static String weakness(SensorSettings<?> sensor, Optional<BestLook> best) {
        return sensor.description().weakness()
                + best.filter(Reasons::isReading).map(Reasons::inWords).orElse(" (no measurable signal)");
    }

    private static String inWords(BestLook look) {
        return look.isUnfound()
                ? format(" (could have been found at ranges up to %.0f m, but the search took too long)", look.range())
                : format(
                        " (best %s at %.0f m, threshold %s)",
                        ReadableNumbers.measured(look.value(), look.unit()),
                        look.range(),
                        ReadableNumbers.measured(look.threshold(), look.unit()));
    }

    private static String percent(int count, int of) {
        double percent = 100.0 * count / of;
        if (count < of && percent >= MOST_ROUNDED) {
            return "more than 99 %";
        }
        return percent < 1.0 ? "less than 1 %" : format("%.0f %%", percent);
    }

    private static String format(String pattern, Object... values) {
        return ReadableNumbers.format(pattern, values);
    }
}
