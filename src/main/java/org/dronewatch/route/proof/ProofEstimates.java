package org.dronewatch.route.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * How often looks that depend on their rays must be estimated for a proof. A single look near its threshold may decide
 * a whole flight, and its estimates are hits and misses, just as the runs are. Enough of them are made for the variance
 * of a prediction to be at most a quarter of that of the runs, and they are shared among the looks so that as few as
 * possible are needed (Neyman's allocation). The variance of one estimate is judged from the look's neighbours, too:
 * otherwise, of many looks that rarely detect the drone, those whose first estimates show no detection would count as
 * certain misses.
 */
final class ProofEstimates {
    /** The variance of the prediction as a fraction of that of the proportion of runs. */
    private static final double VARIANCE = 0.25;

    /** Where fewer runs than this should detect the drone, or miss it, the interval hardly gets narrower. */
    private static final double FEW = 10.0;

    /**
     * The factor by which the number of estimates grows in a step: the more there are, the better it is known how many
     * are needed.
     */
    private static final int FACTOR = 4;

    private final List<BegunFlight> flights;
    private final int runs;

    private final NearbyEstimates nearby;

    /** By flight and look, the number of estimates to be reached next. */
    private final List<int[]> counts = new ArrayList<>();

    private ProofEstimates(List<BegunFlight> flights, int runs) {
        this.flights = flights;
        this.runs = runs;
        this.nearby = new NearbyEstimates(flights);
        flights.forEach(flight -> counts.add(new int[flight.schedule().looks().size()]));
        raise(0.0);
        raise(flights.get(0).settings().alert().response());
    }

    /**
     * Flights with enough estimates, on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param flights flights of the same route from each of the moments at which it begins
     * @param runs number of runs with which they are compared
     */
    static List<BegunFlight> enough(List<BegunFlight> flights, int runs) {
        ProofEstimates estimates = new ProofEstimates(flights, runs);
        while (!estimates.areEnough()) {
            estimates = new ProofEstimates(estimates.more(), runs);
        }
        return estimates.flights;
    }

    /**
     * The standard error of a predicted probability, because looks along the flights are estimated with random rays.
     * Where they show no detection at all, more estimates would take longer than the runs: then the error counts.
     *
     * @param flights flights of the same route from each of the moments at which it begins
     * @param left the time that must be left for a detection to count, s
     */
    static double error(List<BegunFlight> flights, double left) {
        NearbyEstimates nearby = new NearbyEstimates(flights);
        double sum = 0.0;
        for (BegunFlight flight : flights) {
            double[] weights = LookWeights.of(flight, left).each();
            for (int i = 0; i < weights.length; i++) {
                int count = flight.schedule().looks().get(i).estimate().count();
                sum += count > 0 ? weights[i] * weights[i] * nearby.cautiousVariance(flight, i) / count : 0.0;
            }
        }
        return Math.sqrt(sum) / flights.size();
    }

    private boolean areEnough() {
        return IntStream.range(0, flights.size()).allMatch(flight -> {
            List<ScheduledLook> looks = flights.get(flight).schedule().looks();
            return IntStream.range(0, looks.size())
                    .allMatch(i ->
                            counts.get(flight)[i] <= looks.get(i).estimate().count());
        });
    }

    private List<BegunFlight> more() {
        return IntStream.range(0, flights.size())
                .mapToObj(flight -> flights.get(flight).withEstimates(counts.get(flight)))
                .toList();
    }

    /**
     * Raises the numbers of estimates to those that one probability requires.
     *
     * @param left the time that must be left for a detection to count, s
     */
    private void raise(double left) {
        List<LookWeights> weights =
                flights.stream().map(flight -> LookWeights.of(flight, left)).toList();
        double sum = 0.0;
        double detection = 0.0;
        for (int flight = 0; flight < flights.size(); flight++) {
            detection += weights.get(flight).detection() / flights.size();
            for (int i = 0; i < counts.get(flight).length; i++) {
                sum += deviation(flight, i, weights);
            }
        }
        double variance = VARIANCE * Math.max(detection * (1.0 - detection), FEW / runs) / runs;
        for (int flight = 0; flight < flights.size(); flight++) {
            int[] each = counts.get(flight);
            for (int i = 0; i < each.length; i++) {
                double needed = deviation(flight, i, weights) * sum / variance;
                double next = Math.min(
                        Math.ceil(needed), (double) FACTOR * estimate(flight, i).count());
                each[i] = Math.max(each[i], (int) next);
            }
        }
    }

    /** The part of one estimate of a look in the standard deviation of the mean over all flights. */
    private double deviation(int flight, int look, List<LookWeights> weights) {
        return weights.get(flight).each()[look]
                * Math.sqrt(nearby.variance(flights.get(flight), look))
                / flights.size();
    }

    private RayEstimate estimate(int flight, int look) {
        return flights.get(flight).schedule().looks().get(look).estimate();
    }
}
