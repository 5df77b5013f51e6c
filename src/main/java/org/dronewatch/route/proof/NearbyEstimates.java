package org.dronewatch.route.proof;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * What the estimates of a sensor's looks from about the same place on a route show together. A look in which one trace
 * in a thousand detects the drone probably has no detection in its first few estimates, and would never get more; its
 * neighbours, from all moments at which the route begins, show what to expect of it. Where no trace along the whole
 * route has detected the drone, one more trace might have. Immutable.
 */
final class NearbyEstimates {
    /** The number of looks before and after a look that count as its neighbours, by time. */
    private static final double NEIGHBOURS = 3.0;

    /** Tolerance for rounding errors of times, s. */
    private static final double ROUNDING = 1e-9;

    /** The estimates of one sensor's looks by the time on the route, with the sums over all estimates before each. */
    private record Sums(double[] times, double[] sums, double[] counts) {
        static Sums of(List<Look> looks) {
            List<Look> sorted = looks.stream()
                    .sorted(Comparator.comparingDouble(Look::time))
                    .toList();
            double[] times = sorted.stream().mapToDouble(Look::time).toArray();
            double[] sums = new double[times.length + 1];
            double[] counts = new double[times.length + 1];
            for (int i = 0; i < times.length; i++) {
                sums[i + 1] = sums[i] + sorted.get(i).estimate().sum();
                counts[i + 1] = counts[i] + sorted.get(i).estimate().count();
            }
            return new Sums(times, sums, counts);
        }

        double mean(double from, double to) {
            int first = 0;
            while (times[first] < from) {
                first++;
            }
            int end = first;
            while (end < times.length && times[end] <= to) {
                end++;
            }
            return (sums[end] - sums[first]) / (counts[end] - counts[first]);
        }

        /** The mean of all these estimates if a single one of their traces detected the drone. */
        double least() {
            return RayEstimate.ofOneTrace(counts[times.length]);
        }
    }

    /** Some estimates at a time on the route. */
    private record Look(int sensor, double time, RayEstimate estimate) {}

    private final Map<Integer, Sums> bySensor = new HashMap<>();

    /**
     * The estimates of all looks that depend on their rays, except levels.
     *
     * @param flights flights of the same route from each of the moments at which it begins
     */
    NearbyEstimates(List<BegunFlight> flights) {
        List<Look> looks = flights.stream()
                .flatMap(flight -> looks(flight.schedule()))
                .filter(look -> look.estimate().isRandom() && !look.estimate().isLevel())
                .toList();
        looks.stream()
                .mapToInt(Look::sensor)
                .distinct()
                .forEach(sensor -> bySensor.put(
                        sensor,
                        Sums.of(looks.stream()
                                .filter(look -> look.sensor() == sensor)
                                .toList())));
    }

    private static Stream<Look> looks(LookSchedule schedule) {
        return schedule.looks().stream()
                .map(look -> new Look(look.number(), look.time() - schedule.begin(), look.estimate()));
    }

    /**
     * The variance of one estimate of a look, as its own estimates show it or, if it is higher, those of its neighbours
     * and its own together.
     *
     * @param flight flight from one of the moments at which the route begins
     * @param number number of the look in the flight's schedule
     */
    double variance(BegunFlight flight, int number) {
        LookSchedule schedule = flight.schedule();
        ScheduledLook look = schedule.looks().get(number);
        RayEstimate estimate = look.estimate();
        if (!estimate.isRandom() || estimate.isLevel()) {
            return estimate.variance();
        }
        double time = look.time() - schedule.begin();
        double window = NEIGHBOURS / schedule.sensors().get(look.number()).rate() + ROUNDING;
        double mean = bySensor.get(look.number()).mean(time - window, time + window);
        return Math.max(estimate.variance(), RayEstimate.ofTraces(mean));
    }

    /**
     * The variance of one estimate of a look, as {@link #variance}, but no lower than if one of all the sensor's traces
     * along the route had detected the drone.
     *
     * @param flight flight from one of the moments at which the route begins
     * @param number number of the look in the flight's schedule
     */
    double cautiousVariance(BegunFlight flight, int number) {
        ScheduledLook look = flight.schedule().looks().get(number);
        boolean isOfTraces = look.estimate().isRandom() && !look.estimate().isLevel();
        double least =
                isOfTraces ? RayEstimate.ofTraces(bySensor.get(look.number()).least()) : 0.0;
        return Math.max(variance(flight, number), least);
    }
}
