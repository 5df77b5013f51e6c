package org.dronewatch.route.proof;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.PathTask;
import org.dronewatch.route.ResponseTime;
import org.dronewatch.route.Sensing;
import org.dronewatch.route.TimelyDetection;
import org.dronewatch.run.ModelCache;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Observation;
import org.dronewatch.statistics.Proportion;

/**
 * A route that is flown past the sensors of a scene, with every look that a run takes at the drone assessed where it is
 * taken. Positioners only search, since what they follow depends on chance. Immutable and thread-safe.
 */
public final class FlownRoute {
    /** The standard deviation of the time that is left, and of the response, as a fraction of the mean: assumed. */
    public static final double SPREAD = 0.3;

    /** A probability that is estimated from random rays is the mean of this many estimates, of 32 traces each. */
    public static final int ESTIMATES = 16;

    private final SceneSettings settings;
    private final ModelCache models;
    private final Stage stage;
    private final LookSchedule schedule;

    private FlownRoute(SceneSettings settings, ModelCache models, Stage stage, int estimates) {
        this.settings = settings;
        this.models = models;
        this.stage = stage;
        this.schedule = LookSchedule.of(settings, stage, estimates);
    }

    /**
     * Assesses all looks along a route, on the {@link Workers} of the calling thread.
     *
     * @param scene with one drone, such as a {@link RouteScene}; its cues are ignored
     * @param models of the scene
     * @throws IllegalArgumentException if the scene has not exactly one drone
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static FlownRoute of(SceneSettings scene, ModelCache models) {
        return of(scene, models, ESTIMATES);
    }

    /**
     * The same with more or fewer estimates.
     *
     * @param estimates of a look's probability, where it is estimated from random rays, as those of microphones in the
     *     level model are; at least 1
     */
    public static FlownRoute of(SceneSettings scene, ModelCache models, int estimates) {
        int drones = scene.individualDrones().size();
        if (drones != 1) {
            throw new IllegalArgumentException(drones + " drones: must be 1 on a route");
        }
        SceneSettings settings = RouteScene.withoutCues(scene);
        return new FlownRoute(
                settings, models, new Stage(settings, models, settings.run().seed()), estimates);
    }

    /** The probability that a run detects the drone, 0 to 1. */
    public double detection() {
        return 1.0 - schedule.missed(settings.run().duration());
    }

    /** The same by sensor, as if each were the only one. */
    public Map<String, Double> bySensor() {
        List<String> names = List.copyOf(settings.enabledSensors().keySet());
        Map<String, Double> bySensor = new LinkedHashMap<>();
        for (int sensor = 0; sensor < names.size(); sensor++) {
            bySensor.put(
                    names.get(sensor),
                    1.0 - schedule.missed(sensor, settings.run().duration()));
        }
        return bySensor;
    }

    /**
     * The exposure to all looks. A probability of a look counts as {@link org.dronewatch.route.FieldExposure#HIGHEST}
     * at most, as in the search.
     */
    public FlownExposure exposure() {
        return LookExposure.of(schedule, List.copyOf(settings.enabledSensors().keySet()));
    }

    /**
     * The probability of a timely detection, by the EASI model ({@link TimelyDetection}): that the scene's rule raises
     * an alert early enough before the end of the route for the response. All of the flight that is left after an alert
     * is one task, which lasts for as long as planned on average, with a standard deviation of 30 %, and so does
     * the response.
     *
     * @param response time that the response takes, 0 or more, s
     * @return empty where it cannot be computed from single looks: if the rule needs several sensors, combines
     *     probabilities, or asks for detections in several looks of an observer or in more than twelve
     */
    public OptionalDouble interruption(double response) {
        ResponseTime force = new ResponseTime(response, SPREAD * response);
        return AlertChances.of(schedule, settings.alert())
                .map(alerts ->
                        OptionalDouble.of(IntStream.range(0, alerts.times().size())
                                .mapToDouble(i -> {
                                    double left = settings.run().duration()
                                            - alerts.times().get(i);
                                    List<PathTask> tasks = List.of(
                                            new PathTask(1.0, 0.0, 0.0), new PathTask(0.0, left, SPREAD * left));
                                    double inTime = new TimelyDetection(tasks, Sensing.END, 1.0, force).interruption();
                                    return alerts.probabilities().get(i) * inTime;
                                })
                                .sum()))
                .orElse(OptionalDouble.empty());
    }

    /**
     * Flies the route with many seeds, on the {@link Workers} of the calling thread; the same for any number of them.
     * Run {@code i} has the seed {@link RouteProof#seed}. One in twenty is repeated by a
     * {@link org.dronewatch.run.RunSession}.
     *
     * @param runs number of runs, at least 1
     * @param progress receives the number of runs since the last call; from any thread
     * @throws IllegalStateException if a plain run gives something else, which would be an error of this library
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public RouteProof prove(int runs, IntConsumer progress) {
        if (runs < 1) {
            throw new IllegalArgumentException(runs + " runs: must be 1 or more");
        }
        boolean[] isDetected = new boolean[runs];
        Workers.forEach(runs, () -> new SeededFlights(schedule, stage.world()), (flights, run) -> {
            long seed = RouteProof.seed(settings, run);
            Optional<Observation> detected = flights.firstDetection(seed);
            if (run % RouteProof.PLAIN == 0) {
                check(detected, seed);
            }
            isDetected[run] = detected.isPresent();
            progress.accept(1);
        });
        int count =
                (int) IntStream.range(0, runs).filter(run -> isDetected[run]).count();
        return new RouteProof(detection(), bySensor(), new Proportion(count, runs), (runs - 1) / RouteProof.PLAIN + 1);
    }

    private void check(Optional<Observation> replayed, long seed) {
        Optional<Observation> plain = RouteProof.plain(settings, seed, models);
        if (!isSame(replayed, plain)) {
            throw new IllegalStateException("the run with seed " + seed + " first detects the drone " + plain
                    + ", but its looks alone " + replayed);
        }
    }

    /**
     * Whether the same look detects the drone first: with the same values, too, where chance is drawn for each look.
     * Of the looks of observers, only what the next ones depend on is replayed.
     */
    private boolean isSame(Optional<Observation> replayed, Optional<Observation> plain) {
        return replayed.map(Observation::look).equals(plain.map(Observation::look))
                && (replayed.filter(this::isDrawnPerLook).isEmpty() || replayed.equals(plain));
    }

    private boolean isDrawnPerLook(Observation look) {
        return settings.sensors().get(look.sensor()).chance() == Chance.PER_LOOK;
    }
}
