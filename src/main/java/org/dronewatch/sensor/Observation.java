package org.dronewatch.sensor;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.positioner.Sighting;

/**
 * The record of one look of a sensor at a drone, with the truth beside what was measured, for scoring. What the sensor itself
 * reports are its {@link #measurements()}. A sensor may record several looks at one drone at the same time, leave drones out,
 * and report what is no drone.
 *
 * @param sensor name of the sensor
 * @param kind its kind
 * @param drone name of the drone: the ground truth, kept for scoring; empty for a false measurement
 * @param sample index of the sample
 * @param time when the measured event happened, seconds since the start of the run
 * @param arrival when that reached the sensor, seconds since the start of the run: later than {@code time} for sound
 * @param range distance from the sensor to the drone's origin at {@code time}, m; not a number for a false measurement
 * @param value the measured value, in the unit
 * @param threshold what the value must reach for a detection
 * @param unit unit of value and threshold
 * @param figures further results of this look, by name with unit, such as {@code rays} or {@code energy_db}; none for
 *     most sensors
 * @param sighting where the sensor believes the drone to be; empty when it does not tell
 */
public record Observation(
        String sensor,
        String kind,
        String drone,
        long sample,
        double time,
        double arrival,
        double range,
        double value,
        double threshold,
        String unit,
        Map<String, Double> figures,
        Optional<Sighting> sighting) {

    /** The figure of a sensor that knows how likely its look was to detect the drone. */
    public static final String PROBABILITY = "probability";

    private static final String NO_DRONE = "";

    /** Keeps its own figures, in their order. */
    public Observation {
        figures = Collections.unmodifiableMap(new LinkedHashMap<>(figures));
    }

    /** An observation that does not measure where the drone is. */
    public Observation(
            String sensor,
            String kind,
            String drone,
            long sample,
            double time,
            double arrival,
            double range,
            double value,
            double threshold,
            String unit,
            Map<String, Double> figures) {
        this(sensor, kind, drone, sample, time, arrival, range, value, threshold, unit, figures, Optional.empty());
    }

    /** An observation of a signal that arrives at once, without further figures. */
    public Observation(
            String sensor,
            String kind,
            String drone,
            long sample,
            double time,
            double range,
            double value,
            double threshold,
            String unit) {
        this(sensor, kind, drone, sample, time, time, range, value, threshold, unit, Map.of());
    }

    /**
     * What a sensor reports although there is no drone: noise, a bird, an echo.
     *
     * @param sensor name of the sensor
     * @param kind its kind
     * @param look number of the look, from 0
     * @param time when the sensor knew, seconds since the start of the run
     * @param value the measured value, in the unit
     * @param threshold what the value must reach for a detection
     * @param unit unit of value and threshold
     * @param sighting where the sensor believes the source to be
     */
    public static Observation ofNothing(
            String sensor,
            String kind,
            long look,
            double time,
            double value,
            double threshold,
            String unit,
            Optional<Sighting> sighting) {
        return new Observation(
                sensor, kind, NO_DRONE, look, time, time, Double.NaN, value, threshold, unit, Map.of(), sighting);
    }

    /** Whether there is no drone behind it. */
    public boolean isFalse() {
        return drone.equals(NO_DRONE);
    }

    /** What the sensor reports of this look: nothing of a drone that it neither detected nor sighted. */
    public List<Measurement> measurements() {
        return isDetected() || sighting.isPresent()
                ? List.of(new Measurement(sensor, kind, sample, arrival, value, threshold, unit, sighting))
                : List.of();
    }

    /** This observation with where the sensor believes the drone to be, if it does. */
    public Observation withSighting(Optional<Sighting> where) {
        return new Observation(
                sensor, kind, drone, sample, time, arrival, range, value, threshold, unit, figures, where);
    }

    /** The probability that this look detects the drone, 0 to 1; for a sensor that does not know it, whether it did. */
    public double probability() {
        return figures.getOrDefault(PROBABILITY, isDetected() ? 1.0 : 0.0);
    }

    /** Whether the value reaches the threshold. */
    public boolean isDetected() {
        return value >= threshold;
    }

    /** The detection, if the value reaches the threshold. */
    public Optional<Detection> detection() {
        return isDetected() ? Optional.of(new Detection(this)) : Optional.empty();
    }
}
