package org.dronewatch.sensor;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleToIntFunction;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.world.World;

/**
 * Assesses sensors of every kind. If a sensor is not an {@link AssessableSensor}, the assessor takes one look, and
 * derives the cause of a miss from the sensor's field of view and from occlusion. If the look states the probability of
 * a detection, the signal has this probability, which is also its quantity, with a threshold of 0.5: the look's own
 * threshold may have been drawn at random. If the look states none, the signal has the look's value and threshold, and
 * a probability of 1 if the look detects the drone and 0 if not. If the look omits the drone, the probability and the
 * quantity are 0, and the threshold is 1. For use by one thread at a time.
 */
public final class Assessor {
    private static final double EVEN_CHANCE = 0.5;

    private final String id;
    private final SensorSettings<?> settings;
    private final Sensor sensor;
    private final World world;
    private final Cover cover;

    /**
     * An assessor of a new sensor with the given settings in a world.
     *
     * @param id name of the sensor
     */
    public Assessor(String id, SensorSettings<?> settings, World world) {
        this(id, settings, settings.create(), world);
    }

    private Assessor(String id, SensorSettings<?> settings, Sensor sensor, World world) {
        this.id = id;
        this.settings = settings;
        this.sensor = sensor;
        this.world = world;
        this.cover = new Cover(world, settings.position());
    }

    /** An equivalent assessor for use by another thread. Any thread may call this method. */
    public Assessor sibling() {
        Sensor other = sensor instanceof BoundingSensor bounding ? bounding.sibling() : settings.create();
        return new Assessor(id, settings, other, world);
    }

    /**
     * Assesses a drone in this assessor's world, as {@link AssessableSensor#assess} does. Where the ground is not known
     * everywhere below the line of sight, the signal is computed as if nothing were there, and the cause is
     * {@link Cause#UNKNOWN}.
     */
    public Assessment assess(Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom) {
        Assessment known = assessAsIfKnown(drone, pointing, rayRandom);
        return isKnown(drone) ? known : new Assessment(known.signal(), Explanation.of(Cause.UNKNOWN));
    }

    /**
     * The probability given by {@link #assess(Drone, Optional, RandomGenerator)}, without finding the reason for a
     * miss, which would take as long again.
     */
    public double probability(Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom) {
        return sensor instanceof AssessableSensor assessable
                ? assessable.signal(world, drone, pointing, rayRandom).probability()
                : assessAsIfKnown(drone, pointing, rayRandom).probability();
    }

    /**
     * Assesses a drone in this assessor's world, at less cost where possible, as
     * {@link AssessableSensor#assessCoarsely} does; the cause is {@link Cause#UNKNOWN} in the same cases as in
     * {@link #assess(Drone, Optional, RandomGenerator)}.
     */
    public Assessment assessCoarsely(
            Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom, ProbabilityResolution resolution) {
        if (!(sensor instanceof AssessableSensor assessable)) {
            return assess(drone, pointing, rayRandom);
        }
        Assessment known = assessable.assessCoarsely(world, drone, pointing, rayRandom, resolution);
        return isKnown(drone) ? known : new Assessment(known.signal(), Explanation.of(Cause.UNKNOWN));
    }

    /**
     * Bounds that hold at every heading in this assessor's world; see {@link BoundingSensor#boundAtAllHeadings}. Empty
     * for a sensor that is not a {@link BoundingSensor}. Where the ground below the line of sight is not known
     * everywhere, the cause is {@link Cause#UNKNOWN}, with a probability of 0.
     */
    public Optional<AssessmentBounds> boundAtAllHeadings(Drone drone, Position at, Optional<Pointing> pointing) {
        if (!(sensor instanceof BoundingSensor bounding)) {
            return Optional.empty();
        }
        return world.isKnown(settings.position(), at)
                ? bounding.boundAtAllHeadings(world, drone, at, pointing)
                : Optional.of(AssessmentBounds.UNKNOWN);
    }

    /**
     * Bounds for a state of a drone in this assessor's world; see {@link BoundingSensor#bound}. A sensor that is not a
     * {@link BoundingSensor}, and unknown ground, are treated as in {@link #boundAtAllHeadings}.
     */
    public Optional<AssessmentBounds> bound(
            Drone drone, FlightState state, Optional<Pointing> pointing, DoubleToIntFunction steps) {
        if (!(sensor instanceof BoundingSensor bounding)) {
            return Optional.empty();
        }
        return world.isKnown(settings.position(), state.position())
                ? bounding.bound(world, drone, state, pointing, steps)
                : Optional.of(AssessmentBounds.UNKNOWN);
    }

    /** Whether the sensor is a {@link BoundingSensor}. */
    public boolean isBounding() {
        return sensor instanceof BoundingSensor;
    }

    /**
     * An upper bound on the margin of a drone in this assessor's world, dB; see
     * {@link BoundingSensor#greatestMarginDb}. Infinity for a sensor that is not a {@link BoundingSensor}.
     */
    public double greatestMarginDb(Drone drone, FlightState state, Optional<Pointing> pointing) {
        return sensor instanceof BoundingSensor bounding
                ? bounding.greatestMarginDb(world, drone, state, pointing)
                : Double.POSITIVE_INFINITY;
    }

    /** Whether the ground below the line of sight to a drone is known. */
    private boolean isKnown(Drone drone) {
        return world.isKnown(settings.position(), drone.origin());
    }

    private Assessment assessAsIfKnown(Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom) {
        if (sensor instanceof AssessableSensor assessable) {
            return assessable.assess(world, drone, pointing, rayRandom);
        }
        Look look = Look.of(rayRandom.nextLong(), id, 0, 0.0).withPointing(pointing);
        Signal signal = ofDrone(sensor.observe(world, List.of(drone), look), drone)
                .map(this::signal)
                .orElse(Signal.certain(0.0, "", 1.0));
        return new Assessment(signal, signal.isDetected() ? Explanation.DETECTED : explainByOutline(drone, pointing));
    }

    private Signal signal(Observation seen) {
        double probability = seen.probability();
        // An observer has had no time to search in a single look.
        return settings.chance() == Chance.PER_ENCOUNTER || seen.statesProbability()
                ? Signal.of(probability, probability, "", EVEN_CHANCE)
                : Signal.of(probability, seen.value(), seen.unit(), seen.threshold());
    }

    /**
     * The likeliest observation of a drone: a look may omit the drone, or contain several observations of it, and also
     * false alarms.
     */
    private static Optional<Observation> ofDrone(List<Observation> look, Drone drone) {
        return look.stream()
                .filter(one -> one.drone().equals(drone.id()))
                .max(Comparator.comparing(Observation::probability));
    }

    /**
     * An assessment with a signal that was found by other means, such as interpolation; the cause is
     * {@link Cause#UNKNOWN} in the same cases as in {@link #assess(Drone, Optional, RandomGenerator)}.
     */
    public Assessment assess(Signal signal, Drone drone, Optional<Pointing> pointing) {
        if (!signal.isDetected()) {
            return new Assessment(signal, explainMiss(drone, pointing));
        }
        return new Assessment(signal, isKnown(drone) ? Explanation.DETECTED : Explanation.of(Cause.UNKNOWN));
    }

    /** The sensor, if its signal may be interpolated; empty otherwise. */
    public Optional<InterpolableSensor> interpolable() {
        return sensor instanceof InterpolableSensor smooth ? Optional.of(smooth) : Optional.empty();
    }

    /**
     * The signal that would arrive from a drone if there were nothing but air between it and the sensor; see
     * {@link InterpolableSensor#signalInTheOpen}. Empty for a sensor that is not an {@link InterpolableSensor}.
     */
    public Optional<Signal> signalInTheOpen(Drone drone) {
        return interpolable().flatMap(smooth -> smooth.signalInTheOpen(world, drone));
    }

    /**
     * Whether the assessment is certain to be the same at every heading in this assessor's world; see
     * {@link AssessableSensor#isSameAtAllHeadings}. False for a sensor that is not an {@link AssessableSensor}.
     */
    public boolean isSameAtAllHeadings(Drone drone, Optional<Pointing> pointing) {
        return sensor instanceof AssessableSensor assessable && assessable.isSameAtAllHeadings(world, drone, pointing);
    }

    /**
     * Whether the assessment is certain to be the same at every speed; see {@link AssessableSensor#isSameAtAllSpeeds}.
     * False for a sensor that is not an {@link AssessableSensor}.
     */
    public boolean isSameAtAllSpeeds() {
        return sensor instanceof AssessableSensor assessable && assessable.isSameAtAllSpeeds();
    }

    /**
     * The reason why a drone is missed in this assessor's world; see {@link AssessableSensor#explainMiss}. The cause is
     * {@link Cause#UNKNOWN} in the same cases as in {@link #assess(Drone, Optional, RandomGenerator)}.
     */
    public Explanation explainMiss(Drone drone, Optional<Pointing> pointing) {
        if (!isKnown(drone)) {
            return Explanation.of(Cause.UNKNOWN);
        }
        return sensor instanceof AssessableSensor assessable
                ? assessable.explainMiss(world, drone, pointing)
                : explainByOutline(drone, pointing);
    }

    private Explanation explainByOutline(Drone drone, Optional<Pointing> pointing) {
        Optional<Outline> outline = Outlined.fieldOfView(settings, pointing);
        if (outline.isEmpty()) {
            return Explanation.of(Cause.TOO_WEAK);
        }
        Position vector = drone.origin().minus(settings.position());
        if (outline.get() instanceof Outline.Sector sector && !sector.reaches(vector)) {
            return sector.beyond(vector);
        }
        return outline.get().contains(vector)
                ? cover.explain(drone, () -> true, () -> false)
                : Explanation.of(Cause.OUT_OF_VIEW);
    }
}
