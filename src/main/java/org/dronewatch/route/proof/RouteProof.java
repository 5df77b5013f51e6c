package org.dronewatch.route.proof;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.statistics.Proportion;

/**
 * A route checked by trial flights: how often runs of its scene detect the drone, and how often they should. The
 * prediction is {@code 1 - prod(1 - p)} over all looks that a run takes, where p is the probability of detection in a
 * look, assessed at the drone's position at the moment of the look; for cameras whose pictures an observer searches, a
 * run draws one random number per encounter rather than per look, and the prediction is the mean over all values of
 * that number. Positioners only search in these runs, since what they follow depends on chance. Where software looks
 * for spots in the images of a thermal camera, successive looks share frames and so are not independent: for such
 * cameras, the prediction is too high.
 *
 * @param detection the predicted mean probability that a run detects the drone, and the proportion of runs that do
 * @param bySensor by name, the predicted probability that each sensor would detect the drone if it were the only one
 * @param alertInTime as {@code detection}, but for an alert at or before the last moment that leaves enough time for
 *     the scene's response, if flight and response take exactly as long as planned; empty if the scene has no response,
 *     or where the probability cannot be computed ({@link FlownRoute#interruption})
 * @param plain the number of runs, evenly spread, that were repeated as plain runs, by a
 *     {@link org.dronewatch.run.RunSession}
 * @param cued proportion of runs that detected the drone when some of the runs, from run 0 on, were repeated with all
 *     cues; empty if none were repeated
 */
public record RouteProof(
        ProvenChance detection,
        Map<String, Double> bySensor,
        Optional<ProvenChance> alertInTime,
        int plain,
        Optional<Proportion> cued) {
    /** One in this many runs is repeated as a plain run. */
    static final int PLAIN = 20;

    /** Keeps the order of the sensors. */
    public RouteProof {
        bySensor = Collections.unmodifiableMap(new LinkedHashMap<>(bySensor));
    }

    /**
     * Runs a scene with many seeds, on the {@link Workers} of the calling thread; the result does not depend on how
     * many workers there are. Run {@code i} has the seed {@link #seed}. One run in twenty is repeated as a plain run,
     * by a {@link org.dronewatch.run.RunSession}, which must give the same first detection and, where alerts are
     * predicted, the same alert.
     *
     * @param scene scene with one drone, such as a {@link RouteScene}; the scene's cues are ignored
     * @param models models of the scene
     * @param runs number of runs, at least 1
     * @param progress receives the number of runs since the last call; from any thread
     * @throws IllegalArgumentException if the scene does not have exactly one drone, or there is no run
     * @throws IllegalStateException if a plain run gives a different result, which would be a bug in this library
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static RouteProof of(SceneSettings scene, ModelCache models, int runs, IntConsumer progress) {
        return FlownRoute.toProve(scene, models, runs).prove(runs, progress);
    }

    /**
     * Whether a run is repeated as a plain run: one in every {@link #PLAIN} runs, each time one position later among
     * these, so that all moments at which a route begins have their turn.
     */
    static boolean isPlain(int run) {
        return run % PLAIN == run / PLAIN % PLAIN;
    }

    /**
     * How many runs detect the drone with all cues: positioners follow what their own sensors see, and other sensors,
     * or false alarms, cue them. The seeds, and the moments at which the route begins, are those of {@link #of}. Each
     * run is a plain run, by a {@link org.dronewatch.run.RunSession}. The arguments are those of {@link #of}.
     */
    public static Proportion withCues(SceneSettings scene, ModelCache models, int runs, IntConsumer progress) {
        List<SceneSettings> begun = RouteStarts.of(scene.enabledSensors().values()).stream()
                .map(begin -> RouteScene.later(scene, begin))
                .toList();
        boolean[] isDetected = new boolean[runs];
        Workers.forEach(runs, run -> {
            isDetected[run] = new PlainFlight(begun.get(run % begun.size()), models)
                    .fly(seed(scene, run), Optional.empty())
                    .detection()
                    .isPresent();
            progress.accept(1);
        });
        int count =
                (int) IntStream.range(0, runs).filter(run -> isDetected[run]).count();
        return new Proportion(count, runs);
    }

    /** This proof with the result of {@link #withCues(SceneSettings, ModelCache, int, IntConsumer)}. */
    public RouteProof with(Proportion flownWithCues) {
        return new RouteProof(detection, bySensor, alertInTime, plain, Optional.of(flownWithCues));
    }

    /** Whether cues can make a difference at all: whether a sensor is on a positioner. */
    public static boolean hasCues(SceneSettings scene) {
        return scene.enabledSensors().values().stream()
                .anyMatch(sensor -> Mounted.positioner(sensor).isPresent());
    }

    /**
     * The seed of a run, with which the command {@code run} repeats this run.
     *
     * @param run number of the run, from 0
     */
    public static long seed(SceneSettings scene, int run) {
        return Draws.derivedSeed(scene.run().seed(), "run", run);
    }

    /** The predicted mean probability that a run detects the drone, 0 to 1. */
    public double predicted() {
        return detection.predicted();
    }

    /** The proportion of all runs that detected the drone. */
    public Proportion detections() {
        return detection.flown();
    }

    /**
     * The prediction, which does not allow for cues, compared with the runs with cues; empty if there are no such runs.
     */
    public Optional<ProvenChance> withCues() {
        return cued.map(runs -> new ProvenChance(predicted(), detection.error(), runs));
    }

    /** Whether all predictions agree with the runs. */
    public boolean agrees() {
        return detection.agrees() && alertInTime.map(ProvenChance::agrees).orElse(true);
    }
}
