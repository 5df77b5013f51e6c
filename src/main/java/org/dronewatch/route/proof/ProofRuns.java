package org.dronewatch.route.proof;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Observation;
import org.dronewatch.statistics.Proportion;

/** Runs of a route with many seeds, of which some are repeated as plain runs, and what they should give. */
final class ProofRuns {
    private final List<BegunFlight> flights;
    private final ModelCache models;

    /**
     * Runs.
     *
     * @param flights of the same route from each of the moments at which it begins: the runs take them in turn
     */
    ProofRuns(List<BegunFlight> flights, ModelCache models) {
        this.flights = List.copyOf(flights);
        this.models = models;
    }

    /**
     * Flies them; see {@link FlownRoute#prove}.
     *
     * @param bySensor the predictions by sensor
     */
    RouteProof of(int runs, Map<String, Double> bySensor, IntConsumer progress) {
        boolean[] isDetected = new boolean[runs];
        Workers.forEach(
                runs,
                () -> flights.stream()
                        .map(flight -> new SeededFlights(flight.schedule(), flight.world()))
                        .toList(),
                (seeded, run) -> {
                    int begin = run % flights.size();
                    SceneSettings settings = flights.get(begin).settings();
                    long seed = RouteProof.seed(settings, run);
                    Optional<Observation> detected = seeded.get(begin).firstDetection(seed);
                    if (RouteProof.isPlain(run)) {
                        check(detected, settings, seed);
                    }
                    isDetected[run] = detected.isPresent();
                    progress.accept(1);
                });
        int count =
                (int) IntStream.range(0, runs).filter(run -> isDetected[run]).count();
        int plain = (int) IntStream.range(0, runs).filter(RouteProof::isPlain).count();
        return new RouteProof(predicted(runs), bySensor, new Proportion(count, runs), plain, Optional.empty());
    }

    /**
     * The mean probability that a run detects the drone. The first moments have one run more than the others if the
     * number of runs is not a multiple of that of the moments.
     */
    private double predicted(int runs) {
        double[] each = flights.stream()
                .mapToDouble(flight -> flight.detection(MissedLooks.Wait.SEEN))
                .toArray();
        return IntStream.range(0, Math.min(runs, each.length))
                .mapToDouble(begin -> each[begin] * ((runs - 1 - begin) / each.length + 1) / runs)
                .sum();
    }

    private void check(Optional<Observation> replayed, SceneSettings settings, long seed) {
        Optional<Observation> plain = RouteProof.plain(settings, seed, models);
        if (!isSame(replayed, plain, settings)) {
            throw new IllegalStateException("the first detection in the run with seed " + seed + " is " + plain
                    + ", but in the replay of its looks " + replayed);
        }
    }

    /**
     * Whether the same look detects the drone first: with the same values, too, where chance is drawn for each look.
     * Of the looks of observers, only what the next ones depend on is replayed.
     */
    private static boolean isSame(Optional<Observation> replayed, Optional<Observation> plain, SceneSettings settings) {
        return replayed.map(Observation::look).equals(plain.map(Observation::look))
                && (replayed.filter(look -> isDrawnPerLook(look, settings)).isEmpty() || replayed.equals(plain));
    }

    private static boolean isDrawnPerLook(Observation look, SceneSettings settings) {
        return settings.sensors().get(look.sensor()).chance() == Chance.PER_LOOK;
    }
}
