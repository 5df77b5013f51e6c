package org.dronewatch.sensor.acoustic.level;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.acoustic.propagation.Heard;
import org.dronewatch.sensor.acoustic.propagation.Microphone;
import org.dronewatch.sensor.acoustic.propagation.SoundTracer;
import org.dronewatch.world.World;

/**
 * A microphone in the level model: it measures the highest level received along any ray, since levels are not divided
 * among rays. For use by one thread at a time.
 */
public final class LevelHearing implements SoundTracer {
    /** Name of a figure: fraction of the emitted energy that all rays together carry to the microphone. */
    static final String CUMULATED_ENERGY = "cumulated_energy";

    /** A tolerance above the rounding error of the levels along a path, dB. */
    private static final double ROUNDING = 1e-6;

    private final LevelModel model;
    private final Position microphone;
    private final double threshold;
    private final LevelTracer tracer;
    private final LookProbability probability;

    LevelHearing(LevelModel model, Microphone microphone, World world) {
        this.model = model;
        this.microphone = microphone.position();
        this.threshold = microphone.detectionLevel(SiteNoiseLevel.of(model, microphone, world));
        this.tracer = new LevelTracer(model, microphone.position(), microphone.radius(), threshold, world);
        this.probability = new LookProbability(model, microphone.position(), microphone.radius(), threshold, world);
    }

    /**
     * Takes one look.
     *
     * @param fully whether to continue after the first ray that reaches the threshold
     * @param recorder receives every ray segment; {@link RayRecorder#NONE} to record nothing
     */
    public LevelReading listen(Drone drone, RandomGenerator random, boolean fully, RayRecorder recorder) {
        return tracer.trace(drone.origin(), drone.soundLevel(), random, fully, recorder);
    }

    private LevelReading listen(Drone drone, RandomGenerator random) {
        return listen(drone, random, false, RayRecorder.NONE);
    }

    @Override
    public Heard hear(Drone drone, RandomGenerator random) {
        boolean fully = model.listening() == Listening.THOROUGH;
        LevelReading reading = listen(drone, random, fully, RayRecorder.NONE);
        Map<String, Double> figures = new LinkedHashMap<>(reading.figures());
        if (fully) {
            figures.put(CUMULATED_ENERGY, reading.energy());
        }
        return new Heard(reading.bestLevel(), threshold, figures);
    }

    /** {@inheritDoc} Traces only the rays that are needed to decide. */
    @Override
    public boolean hears(Drone drone, RandomGenerator random) {
        return straightLevel(drone) >= threshold - ROUNDING
                && decide(drone, random).detected();
    }

    private LevelReading decide(Drone drone, RandomGenerator random) {
        return tracer.trace(drone.origin(), drone.soundLevel(), random, TracedRays.DECISIVE_OF_LOOK, RayRecorder.NONE);
    }

    @Override
    public Signal signal(Drone drone, RandomGenerator random) {
        LevelAssessment.Look look = rays -> listen(drone, rays);
        return LevelAssessment.signal(straightLevel(drone), threshold, random, look, look, Optional.empty(), false);
    }

    /**
     * {@inheritDoc} Only rays that can lead to a detection are traced; where some looks detect the drone and some do
     * not, more such rays are traced, so that the probability is more accurate. If all that matters is on which side of
     * a limit the probability lies, no more rays are traced after the first look than are needed to decide that.
     */
    @Override
    public Signal coarseSignal(Drone drone, RandomGenerator random, ProbabilityResolution resolution) {
        LevelAssessment.Refinement refinement = rays -> resolution.isSideOnly()
                ? probability.sideOf(resolution.high(), drone.origin(), drone.soundLevel(), rays)
                : probability.of(drone.origin(), drone.soundLevel(), rays);
        return LevelAssessment.signal(
                straightLevel(drone),
                threshold,
                random,
                rays -> decide(drone, rays),
                rays -> tracer.trace(drone.origin(), drone.soundLevel(), rays, TracedRays.DECISIVE, RayRecorder.NONE),
                Optional.of(refinement),
                resolution.isSideOnly());
    }

    @Override
    public boolean isHeardInTheOpen(Drone drone) {
        return straightLevel(drone) >= threshold;
    }

    /**
     * {@inheritDoc} True if the drone's settings state its emission, since the level model does not depend on
     * direction; any other emission may depend on the state of flight.
     */
    @Override
    public boolean isSameAtAllHeadings(Drone drone) {
        return drone.settings().emission().isStatedBySettings();
    }

    /** The level that would arrive directly from a drone without obstructions, dB. */
    private double straightLevel(Drone drone) {
        return drone.soundLevel() - model.attenuation() * drone.origin().distance(microphone);
    }

    @Override
    public void traceRays(Drone drone, RandomGenerator random, RayRecorder recorder) {
        listen(drone, random, true, recorder);
    }
}
