package org.dronewatch.sensor.acoustic;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.AssessableSensor;
import org.dronewatch.sensor.Curve;
import org.dronewatch.sensor.CurveSensor;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Sample;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.acoustic.energy.DecayCurve;
import org.dronewatch.sensor.acoustic.energy.EnergyReading;
import org.dronewatch.sensor.acoustic.energy.EnergyTracer;
import org.dronewatch.sensor.acoustic.energy.SoundSource;
import org.dronewatch.sensor.acoustic.level.LevelTracer;
import org.dronewatch.sensor.acoustic.level.Listening;
import org.dronewatch.sensor.acoustic.propagation.EnergyModel;
import org.dronewatch.sensor.acoustic.propagation.EnergyModel.Criterion;
import org.dronewatch.sensor.acoustic.propagation.LevelModel;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * A microphone that hears each drone for itself. By the level model its value is the best undivided level received. By the
 * energy model it is the A-weighted sound pressure level, or the signal-to-noise ratio of the best band, and the drones are
 * to be given as they were when the sound left them. Keeps scratch memory: one thread at a time.
 *
 * <p>By the energy model an assessment and a look of the same random numbers agree exactly; the probability is 0 or 1. By the
 * level model a look traces once, and where that may go one way or the other, an assessment is the fraction of 32 traces,
 * marked as estimated: then the look's value may differ from the assessment's.
 */
public final class AcousticSensor implements RaySensor, CurveSensor, AssessableSensor {
    private static final String UNIT = "dB";

    /** Share of its first energy down to which a ray is followed for sure when a decay curve is drawn. */
    private static final double PATIENCE = 1e-4;

    /** As many rays as a decay curve needs: its reverberation time scatters by 2 % with them. */
    private static final int DECAY_RAYS = 4_000;

    /** Where more than this share of the sound leaves the site, it has no reverberation to speak of. */
    private static final double OPEN = 0.5;

    /** Below this level, dB, a decay curve is the end of the estimate and not of the sound. */
    private static final double LOWEST_DECAY = -40.0;

    private final AcousticSettings settings;
    private World heard;
    private LevelTracer levels;
    private EnergyTracer energies;
    private Visibility visibility;

    /** A sensor of some settings. */
    public AcousticSensor(AcousticSettings settings) {
        this.settings = settings;
    }

    @Override
    public List<Observation> observe(World world, List<Drone> drones, Sample sample) {
        List<Observation> observations = new ArrayList<>(drones.size());
        for (Drone drone : drones) {
            observations.add(
                    settings.propagation() instanceof EnergyModel model
                            ? observe(world, drone, sample, model.criterion())
                            : observeLevel(world, drone, sample));
        }
        return observations;
    }

    private Observation observeLevel(World world, Drone drone, Sample sample) {
        Listening listening = listen(world, drone, sample.random(drone.id(), RAYS));
        double threshold = settings.detectionLevel(world.backgroundNoise().level());
        return observation(sample, drone, sample.time(), listening.bestLevel(), threshold, listening.figures());
    }

    private Observation observe(World world, Drone drone, Sample sample, Criterion criterion) {
        EnergyReading reading = read(world, drone, sample.random(drone.id(), RAYS));
        BandLevels background = world.backgroundNoise().spectrum();
        Signal signal = signal(reading, background, criterion);
        double emission = sample.time() - drone.distance(settings.position()) / settings.signalSpeed(world);
        return observation(sample, drone, emission, signal.quantity(), signal.threshold(), reading.figures(background));
    }

    private Signal signal(EnergyReading reading, BandLevels background, Criterion criterion) {
        double value = reading.aWeightedLevel();
        double over = background.aWeighted();
        if (criterion == Criterion.BEST_BAND) {
            int band = reading.bestBand(background);
            value = reading.level(band) - background.level(band);
            over = 0.0;
        }
        double threshold = settings.detectionLevel(over);
        return new Signal(value >= threshold ? 1.0 : 0.0, value, UNIT, threshold, reading.standardError(), 0.0);
    }

    @Override
    public Signal signal(World world, Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom) {
        if (settings.propagation() instanceof EnergyModel model) {
            BandLevels background = world.backgroundNoise().spectrum();
            return signal(read(world, drone, rayRandom), background, model.criterion());
        }
        return AcousticAssessment.byLevel(
                straightLevel(drone),
                settings.detectionLevel(world.backgroundNoise().level()),
                rayRandom,
                rays -> listen(world, drone, rays));
    }

    @Override
    public Explanation explainMiss(World world, Drone drone, Optional<Pointing> pointing) {
        hear(world);
        return AcousticAssessment.explainMiss(visibility, settings.position(), drone, isHeardInTheOpen(world, drone));
    }

    private boolean isHeardInTheOpen(World world, Drone drone) {
        if (settings.propagation() instanceof EnergyModel model) {
            EnergyReading open = energies.inTheOpen(sound(drone));
            return signal(open, world.backgroundNoise().spectrum(), model.criterion())
                    .isDetected();
        }
        return straightLevel(drone)
                >= settings.detectionLevel(world.backgroundNoise().level());
    }

    private double straightLevel(Drone drone) {
        return AcousticAssessment.straightLevel((LevelModel) settings.propagation(), settings.position(), drone);
    }

    private Observation observation(
            Sample sample, Drone drone, double emission, double value, double threshold, Map<String, Double> figures) {
        return new Observation(
                sample.sensor(),
                settings.kind(),
                drone.id(),
                sample.index(),
                emission,
                sample.time(),
                drone.distance(settings.position()),
                value,
                threshold,
                UNIT,
                figures);
    }

    /**
     * By the level model: traces until the first ray that is loud enough.
     *
     * @throws IllegalStateException when this sensor follows sound by another model
     */
    public Listening listen(World world, Drone drone, RandomGenerator random) {
        return levels(world).trace(place(drone), drone.soundLevel(), random, false, RayRecorder.NONE);
    }

    /**
     * By the level model: traces everything.
     *
     * @param recorder is told every piece of every ray; {@link RayRecorder#NONE} when nobody wants to know
     * @throws IllegalStateException when this sensor follows sound by another model
     */
    public Listening listenFully(World world, Drone drone, RandomGenerator random, RayRecorder recorder) {
        return levels(world).trace(place(drone), drone.soundLevel(), random, true, recorder);
    }

    /**
     * By the energy model: levels in octave bands.
     *
     * @throws IllegalStateException when this sensor follows sound by another model
     */
    public EnergyReading read(World world, Drone drone, RandomGenerator random) {
        return read(world, drone, random, RayRecorder.NONE);
    }

    private EnergyReading read(World world, Drone drone, RandomGenerator random, RayRecorder recorder) {
        return energies(world).trace(sound(drone), random, recorder);
    }

    @Override
    public void traceRays(World world, Drone drone, RandomGenerator random, RayRecorder recorder) {
        if (settings.propagation() instanceof LevelModel) {
            listenFully(world, drone, random, recorder);
        } else {
            read(world, drone, random, recorder);
        }
    }

    /** By the energy model, in a space that keeps at least half of the sound: how it dies away. */
    @Override
    public List<Curve> curves(World world, Drone drone, RandomGenerator random) {
        if (!(settings.propagation() instanceof EnergyModel model)) {
            return List.of();
        }
        // Late sound is faint: rays must be followed for long, where levels need them only for a short while.
        EnergyModel patient = model.withRays(Math.min(model.rays(), DECAY_RAYS))
                .withRoulette(Math.min(model.roulette(), PATIENCE))
                .withAccuracy(0.0);
        EnergyReading reading = new EnergyTracer(patient, settings.position(), settings.radius(), world)
                .trace(sound(drone), random, RayRecorder.NONE);
        DecayCurve decay = reading.decay();
        if (reading.audit().escaped() > OPEN || decay.t30().isEmpty()) {
            return List.of();
        }
        List<Double> times = new ArrayList<>();
        List<Double> shown = new ArrayList<>();
        double[] curve = decay.levels();
        for (int bin = 0; bin < curve.length && curve[bin] > LOWEST_DECAY; bin++) {
            times.add(bin * DecayCurve.BIN);
            shown.add(curve[bin]);
        }
        String title = String.format(
                Locale.ROOT,
                "sound of '%s' dying away, T30 = %.2f s",
                drone.id(),
                decay.t30().getAsDouble());
        return List.of(new Curve("decay", title, "time [s]", "level of the remaining energy [dB]", times, shown));
    }

    private static SoundSource sound(Drone drone) {
        return new SoundSource(
                place(drone), drone.soundPower(), drone.settings().directivity());
    }

    private static Position place(Drone drone) {
        return Position.of(drone.position());
    }

    private LevelTracer levels(World world) {
        hear(world);
        if (levels == null) {
            throw new IllegalStateException("this sensor follows sound by the energy model: ask it to read");
        }
        return levels;
    }

    private EnergyTracer energies(World world) {
        hear(world);
        if (energies == null) {
            throw new IllegalStateException("this sensor follows sound by the level model: ask it to listen");
        }
        return energies;
    }

    private void hear(World world) {
        if (heard == world) {
            return;
        }
        heard = world;
        visibility = new Visibility(world);
        if (settings.propagation() instanceof LevelModel model) {
            levels = new LevelTracer(
                    model,
                    settings.position(),
                    settings.radius(),
                    settings.detectionLevel(world.backgroundNoise().level()),
                    world);
        } else if (settings.propagation() instanceof EnergyModel model) {
            energies = new EnergyTracer(model, settings.position(), settings.radius(), world);
        }
    }

    /** What this sensor was made from. */
    public AcousticSettings settings() {
        return settings;
    }
}
