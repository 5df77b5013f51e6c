package org.dronewatch.sensor.acoustic;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Curve;
import org.dronewatch.sensor.CurveSensor;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.GroundTruth;
import org.dronewatch.sensor.InterpolableSensor;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.acoustic.array.DirectionFinder;
import org.dronewatch.sensor.acoustic.energy.EnergyHearing;
import org.dronewatch.sensor.acoustic.energy.EnergyReading;
import org.dronewatch.sensor.acoustic.level.LevelHearing;
import org.dronewatch.sensor.acoustic.level.LevelReading;
import org.dronewatch.sensor.acoustic.propagation.Heard;
import org.dronewatch.sensor.acoustic.propagation.Microphone;
import org.dronewatch.sensor.acoustic.propagation.SoundTracer;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * A microphone that hears each drone separately. In the level model, the measured value is the highest level received
 * along any ray, since levels are not divided among rays. In the energy model, the value is the A-weighted sound
 * pressure level, or the signal-to-noise ratio of the best band, and the drones must be given as they were when the
 * sound left them. Keeps scratch memory: for use by one thread at a time.
 *
 * <p>In the energy model, an assessment and a look with the same random numbers agree exactly; the probability is 0 or
 * 1. In the level model, a look traces its rays once; if the result depends on the random rays, the assessed
 * probability is the fraction of 32 traces that detect the drone and is marked as an estimate, and the look's value may
 * differ from the assessment's.
 */
public final class AcousticSensor implements RaySensor, CurveSensor, InterpolableSensor {
    private static final String UNIT = "dB";

    private final AcousticSettings settings;
    private World heard;
    private SoundTracer tracer;
    private Visibility visibility;

    /** A sensor with these settings. */
    public AcousticSensor(AcousticSettings settings) {
        this.settings = settings;
    }

    @Override
    public List<Observation> observe(World world, List<Drone> drones, Look look) {
        List<Observation> observations = new ArrayList<>(drones.size());
        for (Drone drone : drones) {
            observations.add(observe(world, drone, look));
        }
        return observations;
    }

    private Observation observe(World world, Drone drone, Look look) {
        Heard sound = tracer(world).hear(drone, look.random(drone.id(), RAYS));
        double distance = drone.distance(settings.position());
        double emission = look.time() - distance / settings.signalSpeed(world);
        Reading reading = new Reading(sound.value(), sound.threshold(), UNIT);
        Map<String, Double> figures = new LinkedHashMap<>(sound.figures());
        Optional<Sighting> sighting = reading.isDetected()
                ? find(world, drone, sound, look).map(found -> {
                    figures.put("bearing_error_deg", Math.toDegrees(found.bearingError()));
                    found.elevationError()
                            .ifPresent(error -> figures.put("elevation_error_deg", Math.toDegrees(error)));
                    return found.sighting();
                })
                : Optional.empty();
        return new Observation(
                look.id(settings.kind()), new GroundTruth(drone.id(), distance, emission), reading, figures, sighting);
    }

    @Override
    public boolean detects(World world, Drone drone, Look look) {
        return tracer(world).hears(drone, look.random(drone.id(), RAYS));
    }

    /** The direction in which an array hears a drone: where it was when the sound left it. */
    private Optional<DirectionFinder.Found> find(World world, Drone drone, Heard sound, Look look) {
        if (settings.array().isEmpty() || sound.ratios().isEmpty()) {
            return Optional.empty();
        }
        double[] ratios =
                sound.ratios().stream().mapToDouble(Double::doubleValue).toArray();
        return new DirectionFinder(settings.array().get(), world.atmosphere().speedOfSound(), 1.0 / settings.rate())
                .find(settings.position(), drone.origin(), ratios, look.random(drone.id(), Look.ERROR));
    }

    @Override
    public Signal signal(World world, Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom) {
        return tracer(world).signal(drone, rayRandom);
    }

    @Override
    public Assessment assessCoarsely(
            World world,
            Drone drone,
            Optional<Pointing> pointing,
            RandomGenerator rayRandom,
            ProbabilityResolution resolution) {
        Signal signal = tracer(world).coarseSignal(drone, rayRandom, resolution);
        return new Assessment(signal, signal.isDetected() ? Explanation.DETECTED : explainMiss(world, drone, pointing));
    }

    @Override
    public Optional<Signal> signalInTheOpen(World world, Drone drone) {
        return tracer(world).signalInTheOpen(drone);
    }

    @Override
    public Signal signalOnExactPaths(World world, Drone drone) {
        return tracer(world).signalOnExactPaths(drone);
    }

    @Override
    public boolean isInSight(World world, Drone drone) {
        return tracer(world).isInSight(drone);
    }

    /**
     * {@inheritDoc} Since sound also arrives by other paths, a drone behind an obstacle counts as hidden only if it
     * would be heard in the open.
     */
    @Override
    public Explanation explainMiss(World world, Drone drone, Optional<Pointing> pointing) {
        if (!tracer(world).isHeardInTheOpen(drone)) {
            return Explanation.of(Cause.TOO_WEAK);
        }
        return visibility
                .obstacle(settings.position(), drone.origin())
                .map(Explanation::hiddenBy)
                .orElseGet(() -> Explanation.of(Cause.TOO_WEAK));
    }

    @Override
    public boolean isSameAtAllHeadings(World world, Drone drone, Optional<Pointing> pointing) {
        return tracer(world).isSameAtAllHeadings(drone);
    }

    /**
     * Takes a look with the level model, and traces until the first ray that reaches the threshold.
     *
     * @throws IllegalStateException when this sensor uses another propagation model
     */
    public LevelReading listen(World world, Drone drone, RandomGenerator random) {
        return levels(world).listen(drone, random, false, RayRecorder.NONE);
    }

    /**
     * Takes a look with the level model, and traces all rays.
     *
     * @param recorder receives every ray segment; {@link RayRecorder#NONE} to record nothing
     * @throws IllegalStateException when this sensor uses another propagation model
     */
    public LevelReading listenFully(World world, Drone drone, RandomGenerator random, RayRecorder recorder) {
        return levels(world).listen(drone, random, true, recorder);
    }

    private LevelHearing levels(World world) {
        if (tracer(world) instanceof LevelHearing levels) {
            return levels;
        }
        throw new IllegalStateException("this sensor uses another propagation model: 'listen' needs the level model");
    }

    /**
     * Takes a look with the energy model: levels in octave bands.
     *
     * @throws IllegalStateException when this sensor uses another propagation model
     */
    public EnergyReading read(World world, Drone drone, RandomGenerator random) {
        if (tracer(world) instanceof EnergyHearing energies) {
            return energies.read(drone, random, RayRecorder.NONE);
        }
        throw new IllegalStateException("this sensor uses another propagation model: 'read' needs the energy model");
    }

    @Override
    public void traceRays(World world, Drone drone, RandomGenerator random, RayRecorder recorder) {
        tracer(world).traceRays(drone, random, recorder);
    }

    @Override
    public List<Curve> curves(World world, Drone drone, RandomGenerator random) {
        return tracer(world).curves(drone, random);
    }

    private SoundTracer tracer(World world) {
        if (heard != world) {
            heard = world;
            visibility = new Visibility(world);
            tracer = settings.propagation()
                    .tracer(
                            new Microphone(
                                    settings.position(), settings.radius(), settings.threshold(), settings.gain()),
                            world);
        }
        return tracer;
    }

    /** The settings of this sensor. */
    public AcousticSettings settings() {
        return settings;
    }
}
