package org.dronewatch.route;

import java.util.List;
import org.apache.commons.numbers.gamma.Erfc;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Quantity;

/**
 * Whether an intruder is detected early enough to be stopped: the EASI model (estimate of adversary sequence
 * interruption; H. A. Bennett, SAND77-1082, Sandia Laboratories 1977; M. L. Garcia, The Design and Evaluation of
 * Physical Protection Systems, 2nd edition 2008, chapter 13). Durations are independent and normally distributed. The
 * misses of different tasks count as independent, which they are not where the same obstacle hides the intruder from
 * several sensors.
 *
 * @param tasks tasks of the path, from the first to the last, at least one
 * @param sensing at which point of a task the intruder is detected
 * @param communication probability that a detection leads to a response, 0 to 1
 * @param response how long the response takes
 */
public record TimelyDetection(List<PathTask> tasks, Sensing sensing, double communication, ResponseTime response) {
    private static final double ROOT = Math.sqrt(2.0);

    /**
     * Checks the limits, and copies the list.
     *
     * @throws IllegalArgumentException if there is no task, or a value is out of range
     */
    public TimelyDetection {
        tasks = List.copyOf(tasks);
        if (tasks.isEmpty()) {
            throw new IllegalArgumentException("0 tasks: there must be at least one");
        }
        Check.between("communication", communication, 0.0, 1.0, Quantity.RATIO);
    }

    /**
     * The probability that the intruder is interrupted, that is, detected with enough time left for the response:
     * {@code P_I = P_C sum_i PD_i prod_{j<i} (1 - PD_j) Phi((TR_i - RFT) / sqrt(var TR_i + var RFT))}. P_C is the
     * probability of communication, PD_i the probability of a detection in task i, TR_i the mean time left after this
     * detection, RFT the mean response time, var the variance of each of these times, and Phi the standard normal
     * distribution function. Without any spread, a detection is in time if the time left is at least the response time.
     *
     * @return the probability, 0 to 1
     */
    public double interruption() {
        double sum = 0.0;
        double undetected = 1.0;
        double mean = 0.0;
        double variance = 0.0;
        // Backwards for the time left, so that every task is added once.
        double[] inTime = new double[tasks.size()];
        for (int i = tasks.size() - 1; i >= 0; i--) {
            PathTask task = tasks.get(i);
            double ofTask = sensing.left() * task.deviation();
            inTime[i] = inTime(mean + sensing.left() * task.mean(), variance + ofTask * ofTask);
            mean += task.mean();
            variance += task.deviation() * task.deviation();
        }
        for (int i = 0; i < inTime.length; i++) {
            sum += tasks.get(i).probability() * undetected * inTime[i];
            undetected *= 1.0 - tasks.get(i).probability();
        }
        return communication * sum;
    }

    private double inTime(double left, double variance) {
        double early = left - response.mean();
        double spread = Math.sqrt(variance + response.deviation() * response.deviation());
        return spread == 0.0 ? (early >= 0.0 ? 1.0 : 0.0) : 0.5 * Erfc.value(-early / (spread * ROOT));
    }

    /**
     * The effectiveness of the whole system, {@code P_E = P_I P_N}.
     *
     * @param interruption probability P_I of a timely detection, 0 to 1
     * @param neutralisation probability P_N that a response in time stops the intruder, 0 to 1
     */
    public static double effectiveness(double interruption, double neutralisation) {
        return interruption * Check.between("neutralisation", neutralisation, 0.0, 1.0, Quantity.RATIO);
    }
}
