package org.dronewatch.route.proof;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.Confirmation;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Observation;
import org.dronewatch.statistics.Proportion;

/**
 * Runs of a route with many seeds, some of which are repeated as plain runs, and the results that are to be expected.
 */
final class ProofRuns {
    private final List<BegunFlight> flights;
    private final ModelCache models;

    /**
     * Runs.
     *
     * @param flights flights of the same route from each of the moments at which it begins: the runs take them in turn
     */
    ProofRuns(List<BegunFlight> flights, ModelCache models) {
        this.flights = List.copyOf(flights);
        this.models = models;
    }

    /**
     * Flies the route; see {@link FlownRoute#prove}.
     *
     * @param bySensor the predictions by sensor
     */
    RouteProof of(int runs, Map<String, Double> bySensor, IntConsumer progress) {
        boolean[] isDetected = new boolean[runs];
        boolean[] isInTime = new boolean[runs];
        Optional<Confirmation> alerts = alerts();
        Workers.forEach(
                runs,
                () -> flights.stream()
                        .map(flight -> new SeededFlights(flight.schedule(), flight.world()))
                        .toList(),
                (seeded, run) -> {
                    int begin = run % flights.size();
                    SceneSettings settings = flights.get(begin).settings();
                    long seed = RouteProof.seed(settings, run);
                    FlownRun flown = seeded.get(begin).fly(seed, alerts);
                    if (RouteProof.isPlain(run)) {
                        check(flown, settings, seed, alerts);
                    }
                    isDetected[run] = flown.detection().isPresent();
                    isInTime[run] = flown.isAlertedBy(flights.get(begin).critical());
                    progress.accept(1);
                });
        int plain = (int) IntStream.range(0, runs).filter(RouteProof::isPlain).count();
        return new RouteProof(
                proven(isDetected, 0.0, flight -> flight.detection(MissedLooks.Wait.SEEN)),
                bySensor,
                alerts.map(confirmation -> proven(isInTime, response(), BegunFlight::alertInTime)),
                plain,
                Optional.empty());
    }

    private double response() {
        return flights.get(0).settings().alert().response();
    }

    /** How alerts are confirmed, if it matters whether they come in time, and can be predicted. */
    private Optional<Confirmation> alerts() {
        AlertSettings alert = flights.get(0).settings().alert();
        boolean isAsked =
                response() > 0.0 && AlertChances.isKnown(flights.get(0).schedule(), alert);
        return isAsked ? Optional.of(alert.confirm()) : Optional.empty();
    }

    /**
     * The runs in which an event occurred, with its mean probability. The first moments have one run more than the
     * others if the number of runs is not a multiple of that of the moments.
     *
     * @param left the time that must be left for a detection to count, s
     */
    private ProvenChance proven(boolean[] isTrue, double left, ToDoubleFunction<BegunFlight> probability) {
        int runs = isTrue.length;
        double[] each = flights.stream().mapToDouble(probability).toArray();
        double predicted = IntStream.range(0, Math.min(runs, each.length))
                .mapToDouble(begin -> each[begin] * ((runs - 1 - begin) / each.length + 1) / runs)
                .sum();
        int count = (int) IntStream.range(0, runs).filter(run -> isTrue[run]).count();
        return new ProvenChance(predicted, ProofEstimates.error(flights, left), new Proportion(count, runs));
    }

    private void check(FlownRun replayed, SceneSettings settings, long seed, Optional<Confirmation> alerts) {
        FlownRun plain = new PlainFlight(settings, models).fly(seed, alerts);
        if (!isSame(replayed, plain, settings)) {
            throw new IllegalStateException(
                    "the run with seed " + seed + " gives " + plain + ", but the replay of its looks " + replayed);
        }
    }

    /**
     * Whether the same look detects the drone first, and the alert is raised at the same time: with the same values of
     * the look, too, where chance is drawn for each look. Of the looks of observers, only what the next ones depend on
     * is replayed.
     */
    static boolean isSame(FlownRun replayed, FlownRun plain, SceneSettings settings) {
        Optional<Observation> first = replayed.detection();
        return replayed.alert().equals(plain.alert())
                && first.map(Observation::look).equals(plain.detection().map(Observation::look))
                && (first.filter(look -> isDrawnPerLook(look, settings)).isEmpty() || first.equals(plain.detection()));
    }

    private static boolean isDrawnPerLook(Observation look, SceneSettings settings) {
        return settings.sensors().get(look.sensor()).chance() == Chance.PER_LOOK;
    }
}
