package org.dronewatch.sensor;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.positioner.Sighting;

/**
 * The record of one look of a sensor at a drone, with the truth beside the measurement, for scoring. The sensor itself
 * reports the {@link #measurements()} alone. A sensor may observe one drone several times in a look, leave drones out,
 * and report false alarms.
 *
 * @param look the look in which it was made
 * @param truth the drone that caused it
 * @param reading the measured value, and its threshold
 * @param figures further results of this look, by names that include their units, such as {@code rays} or
 *     {@code energy_db}; none for most sensors
 * @param sighting the estimated position or direction of the drone; empty for a sensor that reports no direction
 */
public record Observation(
        LookId look, GroundTruth truth, Reading reading, Map<String, Double> figures, Optional<Sighting> sighting) {

    /** The name of the figure for the probability that the look detects the drone. */
    public static final String PROBABILITY = "probability";

    /**
     * The name of the figure that is 1 if the line of sight of a look leaves the known ground, so that something
     * unknown may have hidden the drone.
     */
    public static final String UNKNOWN = "unknown";

    /** The name of the figure that is 1 for an observation of a bird, for scoring. */
    public static final String BIRD = "bird";

    /** Copies the figures, in their order. */
    public Observation {
        figures = Collections.unmodifiableMap(new LinkedHashMap<>(figures));
    }

    /**
     * An observation of a signal that arrives at once, without further figures and without a sighting.
     *
     * @param look identity of the sensor's look, from {@link Look#id}
     * @param drone name of the drone
     * @param range distance from the sensor to the drone's origin, m
     */
    public Observation(LookId look, String drone, double range, Reading reading) {
        this(look, new GroundTruth(drone, range, look.time()), reading, Map.of(), Optional.empty());
    }

    /**
     * A false alarm: a report caused not by a drone but by noise, a bird or clutter.
     *
     * @param look identity of the sensor's look, from {@link Look#id}
     * @param sighting the estimated position or direction of its source
     */
    public static Observation ofNothing(LookId look, Reading reading, Optional<Sighting> sighting) {
        return new Observation(look, GroundTruth.ofNothing(look.time()), reading, Map.of(), sighting);
    }

    /** This observation with other figures, by names that include their units, in place of the present ones. */
    public Observation withFigures(Map<String, Double> others) {
        return new Observation(look, truth, reading, others, sighting);
    }

    /** This observation with the sensor's estimate of the drone's position or direction, if it reports one. */
    public Observation withSighting(Optional<Sighting> where) {
        return new Observation(look, truth, reading, figures, where);
    }

    /** Name of the sensor. */
    public String sensor() {
        return look.sensor();
    }

    /** Kind of the sensor. */
    public String kind() {
        return look.kind();
    }

    /** Name of the drone: the ground truth; empty for a false measurement. */
    public String drone() {
        return truth.drone();
    }

    /** The time at which the measured signal left its source, seconds since the start of the run. */
    public double time() {
        return truth.time();
    }

    /**
     * The time at which the signal reached the sensor, seconds since the start of the run: later than {@link #time} for
     * sound.
     */
    public double arrival() {
        return look.time();
    }

    /** Distance from the sensor to the drone's origin at {@link #time}, m; NaN for a false measurement. */
    public double range() {
        return truth.range();
    }

    /** The measured value, in {@link #unit}. */
    public double value() {
        return reading.value();
    }

    /** The value required for a detection. */
    public double threshold() {
        return reading.threshold();
    }

    /** Unit of the value and the threshold. */
    public String unit() {
        return reading.unit();
    }

    /** Whether this observation is a false alarm, which no drone caused. */
    public boolean isFalse() {
        return truth.isNothing();
    }

    /**
     * The measurements that the sensor reports from this look; none for a drone that was not detected and whose
     * position or direction was not estimated.
     */
    public List<Measurement> measurements() {
        return isDetected() || sighting.isPresent() ? List.of(new Measurement(look, reading, sighting)) : List.of();
    }

    /**
     * The probability that this look detects the drone, 0 to 1; for a sensor that does not estimate it, 1 if the look
     * detected the drone and 0 if it did not.
     */
    public double probability() {
        return figures.getOrDefault(PROBABILITY, isDetected() ? 1.0 : 0.0);
    }

    /** Whether the look states the {@link #probability()}. */
    public boolean statesProbability() {
        return figures.containsKey(PROBABILITY);
    }

    /** This observation, marked as one whose line of sight leaves the known ground. */
    public Observation asUnknown() {
        return with(UNKNOWN);
    }

    private Observation with(String flag) {
        Map<String, Double> more = new LinkedHashMap<>(figures);
        more.put(flag, 1.0);
        return withFigures(more);
    }

    /** This observation, marked as one of a bird. */
    public Observation asBird() {
        return with(BIRD);
    }

    /** Whether this is an observation of a bird, for scoring: a detection is then a false alarm. */
    public boolean isBird() {
        return figures.containsKey(BIRD);
    }

    /** Whether the line of sight leaves the known ground. */
    public boolean isUnknown() {
        return figures.containsKey(UNKNOWN);
    }

    /** Whether the value reaches the threshold. */
    public boolean isDetected() {
        return reading.isDetected();
    }

    /** The detection, if the value reaches the threshold. */
    public Optional<Detection> detection() {
        return isDetected() ? Optional.of(new Detection(this)) : Optional.empty();
    }
}
