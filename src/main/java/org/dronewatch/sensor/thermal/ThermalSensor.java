package org.dronewatch.sensor.thermal;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.DoublePredicate;
import java.util.function.DoubleToIntFunction;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.BoundingSensor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Cover;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.GroundTruth;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.ImageSpeed;
import org.dronewatch.sensor.optics.ImageTransfer;
import org.dronewatch.sensor.optics.VisibleArea;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.World;

/**
 * A thermal camera. Its signal is the drone's apparent temperature difference dT, attenuated by the air and scaled by
 * the fraction of a pixel that the drone fills, divided by the noise (NETD), as a ratio, not in dB:
 * {@code SNR = |dT| t^R f / NETD}, where t is the transmittance of one kilometre of air, R the range in kilometres and
 * f the filled fraction. The number of line pairs that it resolves is half the square root of the number of the drone's
 * pixels, and lower if the signal is weak: {@code N = sqrt(pixels) / 2 * (1 - minSnr / SNR)}. It is lower still where
 * the lens and the air ({@link ImageTransfer#resolved}) or motion ({@link ImageSpeed}) blur the image. With
 * {@link PointTargets}, the drone need not be resolved. Not thread-safe.
 */
public final class ThermalSensor implements BoundingSensor {
    private final ThermalSettings settings;
    private final Optional<SpotDetector> spots;
    private Optional<Pointing> pointing = Optional.empty();
    private VisibleArea area;
    private Cover cover;
    private Outline outline;
    private ThermalSignal signals;
    private ThermalBounds bounds;

    /** A camera with the given settings. */
    public ThermalSensor(ThermalSettings settings) {
        this.settings = settings;
        this.spots = settings.pointTargets().map(rule -> new SpotDetector(rule, settings));
    }

    @Override
    public List<Observation> observe(World world, List<Drone> drones, Look look) {
        turn(world, look.pointing());
        return drones.stream().map(drone -> look(drone, look)).toList();
    }

    private void turn(World world, Optional<Pointing> where) {
        if (area == null || area.world() != world || !pointing.equals(where)) {
            pointing = where;
            CameraObject camera =
                    new CameraObject(pointing.map(settings::pointed).orElse(settings));
            area = new VisibleArea(camera, world);
            outline = camera.outline();
            signals = new ThermalSignal(
                    settings,
                    spots,
                    pointing,
                    camera.focalLength(),
                    world.light().cn2());
            cover = new Cover(world, settings.position());
            bounds = new ThermalBounds(area, signals, cover);
        }
    }

    @Override
    public Signal signal(World world, Drone drone, Optional<Pointing> where, RandomGenerator rayRandom) {
        turn(world, where);
        return signal(drone, area.of(drone));
    }

    @Override
    public Explanation explainMiss(World world, Drone drone, Optional<Pointing> where) {
        turn(world, where);
        return explainMiss(
                drone, () -> area.of(drone, pixels -> pixels > 0.0) == 0.0, () -> bounds.isDetectedInTheOpen(drone));
    }

    private Explanation explainMiss(Drone drone, BooleanSupplier isInvisible, BooleanSupplier isDetectedInTheOpen) {
        return outline.contains(drone.origin().minus(settings.position()))
                ? cover.explain(drone, isInvisible, isDetectedInTheOpen)
                : Explanation.of(Cause.OUT_OF_VIEW);
    }

    @Override
    public ThermalSensor sibling() {
        return new ThermalSensor(settings);
    }

    /** {@inheritDoc} For a large drone, a few rays suffice to show that it is detected. */
    @Override
    public Assessment assessCoarsely(
            World world,
            Drone drone,
            Optional<Pointing> where,
            RandomGenerator rayRandom,
            ProbabilityResolution resolution) {
        turn(world, where);
        double most = bounds.most(drone).probability();
        double sufficient = most < 1.0 ? resolution.high() : 1.0;
        DoublePredicate enough = found -> {
            Signal signal = signal(drone, found);
            return signal.probability() >= sufficient && signal.isDetected();
        };
        double pixels = bounds.area(drone, enough);
        Signal signal = signal(drone, pixels);
        // Nothing obstructs it, so it would not be detected in the open either.
        boolean isObstructed = area.isObstructed();
        return new Assessment(
                signal,
                signal.isDetected()
                        ? Explanation.DETECTED
                        : explainMiss(
                                drone, () -> pixels == 0.0, () -> isObstructed && bounds.isDetectedInTheOpen(drone)));
    }

    @Override
    public Optional<AssessmentBounds> boundAtAllHeadings(
            World world, Drone drone, Position at, Optional<Pointing> where) {
        turn(world, where);
        return bounds.atAllHeadings(drone, at);
    }

    @Override
    public Optional<AssessmentBounds> bound(
            World world, Drone drone, FlightState state, Optional<Pointing> where, DoubleToIntFunction steps) {
        turn(world, where);
        return bounds.of(drone, state, steps);
    }

    @Override
    public double greatestMarginDb(World world, Drone drone, FlightState state, Optional<Pointing> where) {
        turn(world, where);
        return bounds.most(drone.at(state)).marginDb();
    }

    /**
     * {@inheritDoc} A drone that is outside the image whatever its heading has no area; the cause depends on its
     * position alone.
     */
    @Override
    public boolean isSameAtAllHeadings(World world, Drone drone, Optional<Pointing> where) {
        turn(world, where);
        Position at = drone.origin();
        return area.camera().isOutside(at.x(), at.y(), at.z(), drone.radius());
    }

    private Signal signal(Drone drone, double pixels) {
        return signals.of(drone, pixels);
    }

    private Observation look(Drone drone, Look look) {
        double range = drone.distance(settings.position());
        double pixels = area.of(drone);
        double ratio = signals.toNoise(drone, pixels);
        Signal signal = signal(drone, pixels);
        double probability = signal.quantity();
        double threshold = settings.byChance() ? drawnThreshold(drone, look, probability) : settings.probability();
        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("pixels", pixels);
        figures.put("signal_to_noise", ratio);
        spots.ifPresent(detector -> figures.put("snr_threshold", detector.threshold()));
        figures.put(Observation.PROBABILITY, settings.byChance() ? signal.probability() : probability);
        boolean sighted = probability >= threshold
                || pixels >= settings.lockPixels() && isFollowed(drone, signals.resolved(drone, pixels, ratio), look);
        return new Observation(
                look.id(settings.kind()),
                new GroundTruth(drone.id(), range, look.time()),
                new Reading(probability, threshold, Quantity.RATIO.unit()),
                figures,
                sighted ? Optional.of(settings.sighting(drone.origin(), pixels, area.camera())) : Optional.empty());
    }

    /**
     * Whether a drone with enough pixels is seen well enough for a positioner to follow it: it is detected, whatever
     * the task. A program that finds spots follows what it has found.
     */
    private boolean isFollowed(Drone drone, double resolved, Look look) {
        if (spots.isPresent()) {
            return false;
        }
        double probability = Discrimination.DETECTION.probability(resolved);
        double threshold = settings.byChance()
                ? look.followingThreshold(drone.id(), settings.rate(), probability)
                : settings.probability();
        return probability >= threshold;
    }

    /**
     * The threshold that the probability must reach in a look: the number drawn for the noise of the last frames, or
     * for an observer.
     */
    private double drawnThreshold(Drone drone, Look look, double probability) {
        return spots.map(detector -> detector.drawnThreshold(look, drone.id()))
                .orElseGet(() -> look.observerThreshold(drone.id(), settings.rate(), probability));
    }

    /**
     * Signal-to-noise ratio of a drone.
     *
     * @param excess temperature difference between the drone and its background, K
     * @param range distance of the drone, m
     * @param pixels number of pixels that it covers
     */
    double signalToNoise(double excess, double range, double pixels) {
        return ThermalSignal.toNoise(settings, excess, range, pixels);
    }

    /** The settings of this camera. */
    public ThermalSettings settings() {
        return settings;
    }
}
