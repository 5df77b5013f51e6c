package org.dronewatch.sensor;

import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.positioner.Pointing;

/**
 * One look of one sensor. Its random numbers depend on the run's seed, the names of the sensor and the drone, the
 * look's index and the purpose of the numbers; they do not depend on the order of the work, or on the number of
 * threads.
 *
 * @param sensor name of the sensor in the scene
 * @param index index of the look, from 0
 * @param time seconds since the start of the run
 * @param seed seed of the run
 * @param pointing where a positioner points the sensor now; empty for a sensor on a fixed mount, or one that is to look
 *     along the aim in its settings
 * @param encounters the sensor's encounters with drones before this look; used only where chance decides once per
 *     encounter
 */
public record Look(
        String sensor, long index, double time, long seed, Optional<Pointing> pointing, Encounters encounters) {
    /** The purpose of the numbers that decide whether a drone is detected. */
    public static final String DETECTION = "detection";

    /** The purpose of the numbers that determine measurement errors. */
    public static final String ERROR = "error";

    /** A look along the aim in the sensor's settings, with no earlier encounters. */
    public static Look of(long seed, String sensor, long index, double time) {
        return new Look(sensor, index, time, seed, Optional.empty(), Encounters.NONE);
    }

    /** This look with the given pointing of the sensor's positioner. */
    public Look withPointing(Optional<Pointing> where) {
        return new Look(sensor, index, time, seed, where, encounters);
    }

    /** This look with the given earlier encounters. */
    public Look withEncounters(Encounters before) {
        return new Look(sensor, index, time, seed, pointing, before);
    }

    /**
     * The identity of this look, for its observations.
     *
     * @param kind kind of the sensor
     */
    public LookId id(String kind) {
        return new LookId(sensor, kind, index, time);
    }

    /**
     * The random numbers of this look for one purpose, from the start of their stream; see {@link Draws}.
     *
     * @param drone name of the drone that is looked at; empty if no drone is concerned
     * @param purpose what is drawn, such as {@code detection}
     */
    public RandomGenerator random(String drone, String purpose) {
        return Draws.stream(seed, sensor, drone, index, purpose);
    }

    /**
     * The encounter to which this look at a drone belongs.
     *
     * @param drone name of the drone
     * @param rate looks per second of the sensor, Hz
     */
    public Encounter encounter(String drone, double rate) {
        return encounters.with(drone, time, rate);
    }

    /**
     * The probability that this look at a drone must reach for a detection, for a sensor whose observer decides once
     * per {@link Encounter}.
     *
     * @param drone name of the drone
     * @param rate looks per second of the sensor, Hz
     * @param probability probability of the sensor's {@link Signal}, 0 to 1
     * @return the threshold, above 0; infinite if the observer is able to find the drone but has not found it yet, so
     *     that this look cannot detect it
     */
    public double observerThreshold(String drone, double rate, double probability) {
        Encounter encounter = encounter(drone, rate);
        return encounter.threshold(encounter.isFound(), this, drone, rate, probability);
    }

    /**
     * The probability that this look at a drone must reach for the observer to locate it, so that a positioner can
     * follow it. In all other respects as {@link #observerThreshold}.
     *
     * @param probability probability of the detection task, 0 to 1
     */
    public double followingThreshold(String drone, double rate, double probability) {
        Encounter encounter = encounter(drone, rate);
        return encounter.threshold(encounter.isFollowed(), this, drone, rate, probability);
    }
}
