package org.dronewatch.route.proof;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntConsumer;
import java.util.function.IntToDoubleFunction;
import java.util.function.UnaryOperator;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.ResponseTime;
import org.dronewatch.route.TimelyDetection;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;

/**
 * A route that is flown past the sensors of a scene, with every look that a run takes at the drone assessed at the
 * drone's position at the moment of the look. The route begins at several equally likely moments within the period of
 * the slowest scan ({@link RouteStarts}): all figures are means over these moments. Positioners only search, since what
 * they follow depends on chance. Immutable and thread-safe.
 */
public final class FlownRoute {
    /** The assumed standard deviation, as a fraction of the mean, of the time that is left and of the response time. */
    public static final double SPREAD = 0.3;

    /**
     * The number of estimates, of 32 traces each, whose mean is used for a probability that is estimated from random
     * rays.
     */
    public static final int ESTIMATES = 16;

    private final ModelCache models;
    private final List<String> sensors;
    private final List<BegunFlight> flights;

    private FlownRoute(ModelCache models, List<String> sensors, List<BegunFlight> flights) {
        this.models = models;
        this.sensors = sensors;
        this.flights = List.copyOf(flights);
    }

    private static List<BegunFlight> flights(SceneSettings settings, ModelCache models, int estimates) {
        List<BegunFlight> flights = new ArrayList<>();
        List<Double> begins = RouteStarts.of(settings.enabledSensors().values());
        for (double begin : begins) {
            SceneSettings later = RouteScene.later(settings, begin);
            Stage stage = new Stage(later, models, later.run().seed());
            int each = Math.max(1, estimates / begins.size());
            flights.add(new BegunFlight(later, stage.world(), LookSchedule.of(later, stage, each)));
        }
        return flights;
    }

    /**
     * Assesses all looks along a route, on the {@link Workers} of the calling thread.
     *
     * @param scene scene with one drone, which flies a route, such as a {@link RouteScene}; the scene's cues are
     *     ignored
     * @param models models of the scene
     * @throws IllegalArgumentException if the scene does not have exactly one drone, or the drone flies no route
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static FlownRoute of(SceneSettings scene, ModelCache models) {
        return of(scene, models, ESTIMATES);
    }

    /**
     * Assesses all looks along a route, as {@link #of(SceneSettings, ModelCache)}, but with more or fewer estimates.
     *
     * @param estimates number of estimates of a look's probability where this probability is estimated from random
     *     rays, as for microphones with the level model; at least 1, divided among the moments at which the route
     *     begins
     */
    public static FlownRoute of(SceneSettings scene, ModelCache models, int estimates) {
        return of(scene, models, flights -> flights, estimates);
    }

    /**
     * Assesses all looks along a route, as {@link #of(SceneSettings, ModelCache)}, but with enough estimates for their
     * error to be negligible beside the statistical error of a given number of runs.
     *
     * @param runs number of runs in which the route is flown, at least 1
     */
    public static FlownRoute toProve(SceneSettings scene, ModelCache models, int runs) {
        checkRuns(runs);
        return of(scene, models, flights -> ProofEstimates.enough(flights, runs), ESTIMATES);
    }

    private static FlownRoute of(
            SceneSettings scene, ModelCache models, UnaryOperator<List<BegunFlight>> refined, int estimates) {
        int drones = scene.individualDrones().size();
        if (drones != 1) {
            throw new IllegalArgumentException(drones + " drones: there must be one on a route");
        }
        SceneSettings searching = RouteScene.withoutCues(scene);
        return new FlownRoute(
                models,
                List.copyOf(searching.enabledSensors().keySet()),
                refined.apply(flights(searching, models, estimates)));
    }

    /** The probability that the drone is detected, 0 to 1. */
    public double detection() {
        return flights.stream()
                .mapToDouble(flight -> flight.detection(MissedLooks.Wait.UNSEEN))
                .average()
                .orElseThrow();
    }

    /**
     * By name of the sensor, the probability that this sensor would detect the drone if it were the only one, 0 to 1.
     */
    public Map<String, Double> bySensor() {
        return bySensor(MissedLooks.Wait.UNSEEN);
    }

    private Map<String, Double> bySensor(MissedLooks.Wait wait) {
        return named(sensor -> flights.stream()
                .mapToDouble(flight -> flight.detection(sensor, wait))
                .average()
                .orElseThrow());
    }

    private Map<String, Double> named(IntToDoubleFunction figure) {
        Map<String, Double> named = new LinkedHashMap<>();
        for (int sensor = 0; sensor < sensors.size(); sensor++) {
            named.put(sensors.get(sensor), figure.applyAsDouble(sensor));
        }
        return named;
    }

    /**
     * The exposure to all looks. The probability of a look is capped at
     * {@link org.dronewatch.route.FieldExposure#HIGHEST}, as in the search.
     */
    public FlownExposure exposure() {
        List<LookExposure> each = flights.stream()
                .map(flight -> LookExposure.of(flight.schedule()))
                .toList();
        Map<String, Double> bySensor = named(sensor -> FlownExposure.ofMean(each.stream()
                .mapToDouble(exposure -> exposure.bySensor().get(sensor))
                .toArray()));
        return new FlownExposure(each.stream().map(LookExposure::steps).toList(), bySensor);
    }

    /**
     * The probability of a timely detection, by the EASI model ({@link TimelyDetection}): that the scene's rule raises
     * an alert early enough before the end of the route for the response. The whole remainder of the flight after an
     * alert is one task. The mean duration of this task is the planned one, and the standard deviation is 30 % of the
     * mean; the same holds for the response.
     *
     * @param response time that the response takes, 0 or more, s
     * @return the probability, 0 to 1; empty where it cannot be computed from single looks: if the rule needs several
     *     sensors, combines probabilities, or confirms an alert over more than twelve looks, or over more than one look
     *     if an observer is among the sensors
     */
    public OptionalDouble interruption(double response) {
        ResponseTime force = new ResponseTime(response, SPREAD * response);
        double sum = 0.0;
        for (BegunFlight flight : flights) {
            Optional<AlertChances> alerts =
                    AlertChances.of(flight.schedule(), flight.settings().alert(), MissedLooks.Wait.UNSEEN);
            if (alerts.isEmpty()) {
                return OptionalDouble.empty();
            }
            sum += alerts.get().inTime(flight.settings().run().duration(), force);
        }
        return OptionalDouble.of(sum / flights.size());
    }

    /**
     * Flies the route with many seeds, on the {@link Workers} of the calling thread; the result does not depend on how
     * many workers there are. Run {@code i} has the seed {@link RouteProof#seed}, and the runs begin at the moments of
     * {@link RouteStarts} in turn. One run in twenty is repeated as a plain run, by a
     * {@link org.dronewatch.run.RunSession}. In a run, observers also search for the drone while it waits for its route
     * to begin: if they could see it there, the probability of detection that the {@link RouteProof} predicts is higher
     * than {@link #detection}.
     *
     * @param runs number of runs, at least 1
     * @param progress receives the number of runs since the last call; from any thread
     * @throws IllegalStateException if a plain run gives a different result, which would be a bug in this library
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public RouteProof prove(int runs, IntConsumer progress) {
        checkRuns(runs);
        return new ProofRuns(flights, models).of(runs, bySensor(MissedLooks.Wait.SEEN), progress);
    }

    private static void checkRuns(int runs) {
        if (runs < 1) {
            throw new IllegalArgumentException(runs + " runs: there must be at least one");
        }
    }
}
