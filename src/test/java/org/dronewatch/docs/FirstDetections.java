package org.dronewatch.docs;

import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.dronewatch.sensor.Observation;

/** The distribution of the range of a first detection over all runs, from the probabilities of the looks of one. */
final class FirstDetections {
    private FirstDetections() {}

    private static double probability(Observation look) {
        return look.figures().get(Observation.PROBABILITY);
    }

    /** The probability that a look so far has detected the drone, if each decides for itself. */
    static double[] independentLooks(List<Observation> looks) {
        double[] detected = new double[looks.size()];
        double missed = 1.0;
        for (int i = 0; i < detected.length; i++) {
            missed *= 1.0 - probability(looks.get(i));
            detected[i] = 1.0 - missed;
        }
        return detected;
    }

    /**
     * The same for observers, who differ in the probability u that they need, and who search at the rate P / 3.4 s
     * while it is at least u.
     */
    static double[] observers(List<Observation> looks) {
        int all = 2000;
        double[] now = looks.stream().mapToDouble(FirstDetections::probability).toArray();
        double[] time = looks.stream().mapToDouble(Observation::time).toArray();
        double[] detected = new double[now.length];
        for (int observer = 0; observer < all; observer++) {
            double able = (observer + 0.5) / all;
            double exponent = 0.0;
            double found = 0.0;
            for (int i = 1; i < now.length; i++) {
                if (now[i] >= able) {
                    exponent += now[i] * (time[i] - time[i - 1]) / 3.4;
                    found = -Math.expm1(-exponent) / all;
                }
                detected[i] += found;
            }
        }
        return detected;
    }

    /** The range by which a fraction of runs has detected the drone. */
    static OptionalDouble quantile(List<Observation> looks, double[] detected, double share) {
        return IntStream.range(0, detected.length)
                .filter(i -> detected[i] >= share)
                .mapToDouble(i -> looks.get(i).range())
                .findFirst();
    }
}
