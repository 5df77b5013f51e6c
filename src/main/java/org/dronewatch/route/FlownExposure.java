package org.dronewatch.route;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * How exposed a drone is on a route as it is flown: the exposure to every look that the sensors take, assessed at the
 * drone's position at the moment of the look rather than in a cell of a field. The route begins at several equally
 * likely moments within the period of the slowest scan: probabilities are means over these moments.
 *
 * @param flights for each of these moments, the looks that may detect the drone, in order of time; there must be at
 *     least one moment
 * @param bySensor by name, the exposure to each sensor along the whole route, {@linkplain #ofMean averaged} over these
 *     flights, in the order of the scene
 * @param alertInTime the probability that an alert comes early enough for a response, by the scene's rule, 0 to 1;
 *     empty if it is not known, or no response is required
 */
public record FlownExposure(List<List<Step>> flights, Map<String, Double> bySensor, OptionalDouble alertInTime) {
    /**
     * What a look adds to the exposure.
     *
     * @param before time of the sensor's previous look, or of the start of the route if that is later, s since the
     *     start of the route
     * @param time time of the look, s since the start of the route
     * @param exposure exposure that the look adds, above 0; {@code -ln(1 - p)} for an independent look with the
     *     probability of detection p
     */
    public record Step(double before, double time, double exposure) {
        private double by(double until) {
            return time <= until ? exposure : 0.0;
        }

        private double chanceBy(double until, int flights) {
            double chance = -Math.expm1(-exposure);
            double part = (time - before) / flights;
            return time <= until ? chance : Math.max(0.0, 1.0 - (time - until) / part) * chance;
        }
    }

    /**
     * Copies the lists and the map.
     *
     * @throws IllegalArgumentException if there is no flight
     */
    public FlownExposure {
        flights = flights.stream().map(List::copyOf).toList();
        bySensor = Collections.unmodifiableMap(new LinkedHashMap<>(bySensor));
        if (flights.isEmpty()) {
            throw new IllegalArgumentException("0 flights: there must be at least one");
        }
    }

    /** An exposure for which it is not known whether an alert comes in time. */
    public FlownExposure(List<List<Step>> flights, Map<String, Double> bySensor) {
        this(flights, bySensor, OptionalDouble.empty());
    }

    /**
     * This exposure with the probability that an alert comes early enough for a response, 0 to 1; empty if not known.
     */
    public FlownExposure withAlertInTime(OptionalDouble probability) {
        return new FlownExposure(flights, bySensor, probability);
    }

    /**
     * The exposure to all looks up to and including a time, s since the start: {@code -ln} of the mean probability that
     * all of these looks miss the drone.
     */
    public double until(double time) {
        return ofMean(flights.stream()
                .mapToDouble(looks ->
                        looks.stream().mapToDouble(look -> look.by(time)).sum())
                .toArray());
    }

    /**
     * The mean number of looks up to a time that detect the drone, for pictures of where they do. A look of one flight
     * represents those at any moment since that of the flight before: it is spread evenly over this part of the time
     * since the sensor's previous look.
     */
    double hitsUntil(double time) {
        return flights.stream()
                .mapToDouble(looks -> looks.stream()
                        .mapToDouble(look -> look.chanceBy(time, flights.size()))
                        .sum())
                .average()
                .orElseThrow();
    }

    /**
     * The probability, 0 to 1, of a detection up to and including a time, if looks came so often that the moment at
     * which the route begins did not matter, as the search assumes: {@code 1 - exp(-E)}, where E is the mean exposure
     * of the flights.
     *
     * @param until the last moment at which a detection counts, s since the start; it may be infinite
     */
    public double detectionByFastLooks(double until) {
        return -Math.expm1(-flights.stream()
                .mapToDouble(looks ->
                        looks.stream().mapToDouble(look -> look.by(until)).sum())
                .average()
                .orElseThrow());
    }

    /**
     * The exposure that gives the mean probability of several flights, {@code -ln(mean of exp(-E))}.
     *
     * @param exposures E of each flight, at least one; they may be large
     */
    public static double ofMean(double[] exposures) {
        double least = Double.POSITIVE_INFINITY;
        for (double exposure : exposures) {
            least = Math.min(least, exposure);
        }
        double missed = 0.0;
        for (double exposure : exposures) {
            missed += Math.exp(least - exposure);
        }
        return least - Math.log(missed / exposures.length);
    }

    /** The probability, 0 to 1, that the drone is detected by a look up to and including a time, s since the start. */
    public double detection(double until) {
        return -Math.expm1(-until(until));
    }

    /**
     * The median time of the first detection among the flights on which there is one, s since the start; empty if no
     * look can detect the drone.
     */
    public OptionalDouble medianDetection() {
        double wanted = 0.5 * detection(Double.POSITIVE_INFINITY);
        double[] times = flights.stream()
                .flatMap(List::stream)
                .mapToDouble(Step::time)
                .sorted()
                .toArray();
        int low = 0;
        int high = times.length - 1;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (detection(times[middle]) >= wanted) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        return times.length == 0 ? OptionalDouble.empty() : OptionalDouble.of(times[low]);
    }
}
