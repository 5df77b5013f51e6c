package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Curve;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Criterion;
import org.dronewatch.sensor.acoustic.propagation.ArcSight;
import org.dronewatch.sensor.acoustic.propagation.Heard;
import org.dronewatch.sensor.acoustic.propagation.Microphone;
import org.dronewatch.sensor.acoustic.propagation.PathBending;
import org.dronewatch.sensor.acoustic.propagation.SoundTracer;
import org.dronewatch.sensor.acoustic.tone.HeardTone;
import org.dronewatch.sensor.acoustic.tone.LineSpectrum;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * A microphone in the energy model: it measures the A-weighted sound pressure level, or the signal-to-noise ratio of
 * the best band. Not thread-safe.
 */
public final class EnergyHearing implements SoundTracer {
    private static final String UNIT = "dB";

    /** If more than this fraction of the sound leaves the site, there is no appreciable reverberation. */
    private static final double OPEN = 0.5;

    /** Below this level, dB, a decay curve shows the end of the estimate, not that of the sound. */
    private static final double LOWEST_DECAY = -40.0;

    /** Name of a figure: A-weighted level of background and noise sources together. */
    private static final String BACKGROUND = "background_db";

    /** Name of a figure: 1 if the sound of all noise sources is known to the accuracy of a reading. */
    private static final String BACKGROUND_CONVERGED = "background_converged";

    private final EnergyModel model;
    private final Microphone microphone;
    private final World world;
    private final EnergyTracer tracer;
    private final PathBending bending;
    private final ArcSight sight;
    private Optional<SiteNoise> noise = Optional.empty();

    EnergyHearing(EnergyModel model, Microphone microphone, World world) {
        this.model = model;
        this.microphone = microphone;
        this.world = world;
        this.bending = new PathBending(world);
        this.sight = new ArcSight(world);
        this.tracer = new EnergyTracer(model, microphone.position(), microphone.radius(), world);
    }

    /**
     * Takes one look, which gives levels in octave bands.
     *
     * @param recorder receives every ray segment; {@link RayRecorder#NONE} to record nothing
     */
    public EnergyReading read(Drone drone, RandomGenerator random, RayRecorder recorder) {
        return read(sound(drone), random, recorder);
    }

    private EnergyReading read(SoundSource sound, RandomGenerator random, RayRecorder recorder) {
        background();
        return tracer.trace(sound, random, recorder);
    }

    @Override
    public Heard hear(Drone drone, RandomGenerator random) {
        SoundSource sound = sound(drone);
        EnergyReading reading = read(sound, random, RayRecorder.NONE);
        Signal signal = signal(reading, sound.lines());
        return new Heard(
                signal.quantity(), signal.threshold(), figures(reading, sound.lines()), ratios(reading.forDetection()));
    }

    private List<Double> ratios(EnergyReading reading) {
        return IntStream.range(0, OctaveBands.COUNT)
                .mapToObj(band -> reading.level(band) - background().level(band))
                .toList();
    }

    private Map<String, Double> figures(EnergyReading reading, LineSpectrum lines) {
        Map<String, Double> figures = new LinkedHashMap<>(reading.figures(background()));
        if (!world.noiseSources().isEmpty() || world.atmosphere().wind().speed() > 0.0) {
            figures.put(BACKGROUND, background().aWeighted());
        }
        if (!world.noiseSources().isEmpty()) {
            figures.put(BACKGROUND_CONVERGED, noise().isConverged() ? 1.0 : 0.0);
        }
        // For the sound that decides, as for the value of the look.
        for (HeardTone tone : lines.heard(reading.forDetection()::energy, background())) {
            String name = "tone_" + tone.harmonic();
            figures.put(name + "_hz", tone.band().frequency());
            figures.put(name + "_width_hz", tone.band().width());
            figures.put(name + "_snr_db", tone.snr());
        }
        return figures;
    }

    /** The noise without drones, by band. */
    private BandLevels background() {
        return noise().levels();
    }

    /** The noise of the site, computed when it is first needed. */
    private SiteNoise noise() {
        if (noise.isEmpty()) {
            noise = Optional.of(SiteNoise.at(microphone.position(), world, tracer));
            tracer.listenIn(noise.get().levels());
        }
        return noise.get();
    }

    @Override
    public Signal signal(Drone drone, RandomGenerator random) {
        SoundSource sound = sound(drone);
        return signal(read(sound, random, RayRecorder.NONE), sound.lines());
    }

    /**
     * The signal of a reading. A reading that rests on too few rays is not used for the decision: the exact paths alone
     * decide.
     */
    private Signal signal(EnergyReading whole, LineSpectrum lines) {
        EnergyReading reading = whole.forDetection();
        double value = reading.aWeightedLevel();
        double over = background().aWeighted();
        if (model.criterion() != Criterion.A_WEIGHTED) {
            value = ratio(reading, lines);
            over = 0.0;
        }
        double threshold = microphone.detectionLevel(over);
        return new Signal(value >= threshold ? 1.0 : 0.0, value, UNIT, threshold, reading.standardError(), 0.0);
    }

    /**
     * The signal-to-noise ratio of the best line, if lines are listened for and there are any, or of the best octave
     * band.
     */
    private double ratio(EnergyReading reading, LineSpectrum lines) {
        if (model.criterion() == Criterion.NARROW_BAND) {
            Optional<HeardTone> best = lines.best(reading::energy, background());
            if (best.isPresent()) {
                return best.get().snr();
            }
        }
        int band = reading.bestBand(background());
        return reading.level(band) - background().level(band);
    }

    @Override
    public Optional<Signal> signalInTheOpen(Drone drone) {
        return Optional.of(inTheOpen(drone));
    }

    @Override
    public Signal signalOnExactPaths(Drone drone) {
        background();
        SoundSource sound = sound(drone);
        return signal(tracer.onExactPaths(sound), sound.lines());
    }

    private Signal inTheOpen(Drone drone) {
        SoundSource sound = sound(drone);
        return signal(tracer.inTheOpen(sound), sound.lines());
    }

    @Override
    public boolean isInSight(Drone drone) {
        Position from = drone.origin();
        Position to = microphone.position();
        Position along = to.minus(from);
        double curvature = bending.between(from, to).along(along.x(), along.y(), along.z());
        return sight.isFree(from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), curvature);
    }

    @Override
    public boolean isHeardInTheOpen(Drone drone) {
        return inTheOpen(drone).isDetected();
    }

    /**
     * {@inheritDoc} True if the drone's settings state its emission, whose directivity then depends only on the
     * elevation. False for a drone with tones under the narrow-band criterion, since the radial speed shifts the tones.
     */
    @Override
    public boolean isSameAtAllHeadings(Drone drone) {
        boolean hearsLines =
                model.criterion() == Criterion.NARROW_BAND && !drone.tones().isEmpty();
        return drone.settings().emission().isStatedBySettings() && !hearsLines;
    }

    @Override
    public void traceRays(Drone drone, RandomGenerator random, RayRecorder recorder) {
        read(drone, random, recorder);
    }

    /**
     * {@inheritDoc} In a space that retains at least half of the sound, the curves are the decay of the sound and the
     * reverberation time in each octave band; otherwise there are none.
     */
    @Override
    public List<Curve> curves(Drone drone, RandomGenerator random) {
        EnergyTracer patient =
                new EnergyTracer(Reverberation.patient(model), microphone.position(), microphone.radius(), world);
        Reverberation reverberation = Reverberation.measure(patient, sound(drone), random, OPEN);
        Optional<Reverberation.Time> time = reverberation.time();
        if (reverberation.escaped() > OPEN || time.isEmpty()) {
            return List.of();
        }
        return List.of(decay(reverberation, time.get(), drone.id()), overFrequency(reverberation, drone.id()));
    }

    private static Curve decay(Reverberation reverberation, Reverberation.Time time, String drone) {
        List<Double> times = new ArrayList<>();
        List<Double> shown = new ArrayList<>();
        double[] curve = reverberation.decay().levels();
        for (int bin = 0; bin < curve.length && curve[bin] > LOWEST_DECAY; bin++) {
            times.add(bin * DecayCurve.BIN);
            shown.add(curve[bin]);
        }
        String title = String.format(
                Locale.ROOT,
                "decay of the sound of '%s', T30 = %.2f s, standard error %.2f s",
                drone,
                time.seconds(),
                time.error());
        return new Curve("decay", title, "time [s]", "level of the remaining energy [dB]", times, shown);
    }

    private static Curve overFrequency(Reverberation reverberation, String drone) {
        List<Double> frequencies = new ArrayList<>();
        List<Double> times = new ArrayList<>();
        double worst = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            Optional<Reverberation.Time> time = reverberation.time(band);
            if (time.isPresent()) {
                frequencies.add((double) OctaveBands.nominal(band));
                times.add(time.get().seconds());
                worst = Math.max(worst, time.get().error());
            }
        }
        String title = String.format(
                Locale.ROOT, "reverberation time for '%s' by octave band, standard error up to %.2f s", drone, worst);
        return new Curve("t30", title, "midband frequency [Hz]", "T30 [s]", frequencies, times);
    }

    private SoundSource sound(Drone drone) {
        SoundSource sound = new SoundSource(
                drone.origin(), drone.soundPower(), drone.settings().directivity());
        return drone.tones().isEmpty() ? sound : sound.with(lines(drone));
    }

    private LineSpectrum lines(Drone drone) {
        return new LineSpectrum(
                drone.tones(),
                drone.soundPower(),
                approach(drone),
                world.atmosphere().speedOfSound(),
                bending.windAt(drone.origin()));
    }

    /** The drone's speed along the straight line to the microphone, m/s. */
    private double approach(Drone drone) {
        Position line = microphone.position().minus(drone.origin());
        double distance = line.length();
        return distance > 0.0 ? Position.of(drone.velocity()).dot(line) / distance : 0.0;
    }
}
