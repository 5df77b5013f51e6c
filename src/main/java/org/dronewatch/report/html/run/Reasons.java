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
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.SensorSettings;

/**
 * Explains why a sensor did not detect a drone, and for what fraction of the time: the drone was out of range, out of
 * the field of view, hidden (and by which model), of a kind that the sensor cannot detect, or its signal was too weak.
 */
final class Reasons {
    /** Number of instants of a run that are examined, besides its start. */
    static final int MOMENTS = 400;

    /** Percentages of at least this would be printed as 100 %, which is kept for the whole time. */
    private static final double MOST_ROUNDED = 99.5;

    private final SceneSettings settings;
    private final Stage stage;
    private final Pointings pointings;
    private final LineOfSight sight;
    private final Map<String, Assessor> assessors = new HashMap<>();
    private final List<Map<String, Drone>> moments = new ArrayList<>();
    private final double simulated;
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
        this.simulated = simulated;
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
     * @param drones drones that the sensor did not detect, at least one
     * @param best the best look at any of them
     */
    String of(String sensor, List<String> drones, Optional<BestLook> best) {
        SensorSettings<?> missing = settings.sensors().get(sensor);
        String weak = weakness(missing, best);
        Fractions fractions = fractions(sensor, drones, 0.0, (drone, time) -> true, always(weak));
        int tooWeak = fractions.counts().getOrDefault(weak, 0);
        boolean measured = tooWeak > 0 && best.filter(Reasons::isReading).isPresent();
        String distance = measured ? "" : format("; the closest approach was %.0f m", fractions.nearest());
        boolean quiet = !Sightline.hasFieldOfView(missing) && tooWeak > 0 && fractions.gliding() > 0;
        return fractions.inWords("always %s", 1.0)
                + distance
                + (quiet
                        ? "; motors off " + percent((double) fractions.gliding() / fractions.missed()) + " of the time"
                        : "");
    }

    /** Why a sensor does not detect some drones again that it has lost, in words. */
    String afterLoss(String sensor, List<String> drones, double time, RunLooks looks) {
        return fractions(sensor, drones, time, (drone, later) -> true, gap(sensor, looks))
                .inWords("%s from then on", 1.0);
    }

    /**
     * Why a sensor that detects some drones at times does not detect them at other times, in words; several reasons are
     * given with the part of the run for which each holds.
     *
     * @param detected when the sensor detects which drone
     * @param looks looks of the run
     */
    String whileUndetected(String sensor, List<String> drones, DetectionIntervals detected, RunLooks looks) {
        double part = drones.stream()
                .mapToDouble(drone -> missedPart(sensor, drone, detected))
                .average()
                .orElseThrow();
        Fractions fractions = fractions(
                sensor, drones, 0.0, (drone, time) -> !detected.isDetected(sensor, drone, time), gap(sensor, looks));
        return fractions.missed() == 0 ? "in intervals too short to examine" : fractions.inWords("%s", part);
    }

    /**
     * The fraction of the run for which a sensor does not detect a drone, 0 to 1.
     *
     * @param detected when the sensor detects which drone
     */
    double missedPart(String sensor, String drone, DetectionIntervals detected) {
        return simulated > 0.0 ? 1.0 - detected.detectedFor(sensor, drone, simulated) / simulated : 0.0;
    }

    /** Explains why a sensor misses a drone at a time, s since the start. */
    @FunctionalInterface
    private interface Explainer {
        MomentReason at(Assessor assessor, Drone drone, Optional<Pointing> pointing, double time);
    }

    /** For a drone that the sensor detects at other times. */
    private Explainer gap(String sensor, RunLooks looks) {
        SensorSettings<?> missing = settings.sensors().get(sensor);
        return (assessor, drone, pointing, time) -> MomentReason.ofGap(
                assessor,
                missing,
                drone,
                pointing,
                Look.of(settings.run().seed(), sensor, 0, time),
                looks.hasObserved(sensor, drone.id(), time));
    }

    private static Explainer always(String weak) {
        return (assessor, drone, pointing, time) -> MomentReason.ofMiss(assessor, drone, pointing, weak);
    }

    /** Selects times at which a drone is missed, s since the start. */
    @FunctionalInterface
    private interface Missed {
        boolean at(String drone, double time);
    }

    /** The number of instants of a run at which each reason held, and at how many of them motors were off. */
    private record Fractions(Map<String, Integer> counts, double nearest, int gliding) {
        int missed() {
            return counts.values().stream().mapToInt(Integer::intValue).sum();
        }

        /**
         * The reasons in words; a single one by a pattern that says when it held.
         *
         * @param part the fraction of the time for which any of them held, 0 to 1
         */
        String inWords(String throughout, double part) {
            List<Map.Entry<String, Integer>> sorted = new ArrayList<>(counts.entrySet());
            sorted.sort(Map.Entry.comparingByValue(Comparator.reverseOrder()));
            if (sorted.size() == 1) {
                return format(throughout, sorted.get(0).getKey());
            }
            int missed = missed();
            return sorted.stream()
                    .map(one -> percentOfSome(part * one.getValue() / missed) + " of the time: " + one.getKey())
                    .collect(Collectors.joining("; "));
        }
    }

    private Fractions fractions(String sensor, List<String> drones, double from, Missed missed, Explainer explainer) {
        SensorSettings<?> missing = settings.sensors().get(sensor);
        Assessor assessor = assessors.computeIfAbsent(sensor, id -> new Assessor(id, missing, stage.world()));
        Map<String, Integer> counts = new LinkedHashMap<>();
        Map<String, Evidence> evidence = new HashMap<>();
        double nearest = Double.POSITIVE_INFINITY;
        int gliding = 0;
        int first = (int) Math.min(MOMENTS, Math.ceil(from / step));
        for (int i = first; i <= MOMENTS; i++) {
            Optional<Pointing> pointing = pointings.at(sensor, i * step);
            for (String drone : drones) {
                if (!missed.at(drone, i * step)) {
                    continue;
                }
                Drone flying = moments.get(i).get(drone);
                Position position = flying.origin();
                nearest = Math.min(nearest, position.distance(missing.position()));
                gliding += flying.isPowered() ? 0 : 1;
                MomentReason reason = explainer.at(assessor, flying, pointing, i * step);
                Evidence shown = evidence.computeIfAbsent(reason.words(), one -> new Evidence());
                shown.add(reason.explanation());
                if (reason.explanation().cause().isHidden()) {
                    building(missing.position(), position).ifPresent(shown::addBuilding);
                }
                counts.merge(reason.words(), 1, Integer::sum);
            }
        }
        return new Fractions(explained(counts, evidence), nearest, gliding);
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

    private static String percent(double part) {
        return part == 1.0 ? "100 %" : percentOfSome(part);
    }

    /** A part of the time that is not the whole time, however close to it, in percent. */
    static String percentOfSome(double part) {
        double percent = 100.0 * part;
        if (percent >= MOST_ROUNDED) {
            return "more than 99 %";
        }
        return percent < 1.0 ? "less than 1 %" : format("%.0f %%", percent);
    }

    private static String format(String pattern, Object... values) {
        return ReadableNumbers.format(pattern, values);
    }
}
