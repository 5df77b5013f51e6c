package org.dronewatch.sensor.radar;

import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Quantity;

/**
 * The probability of detection by a square-law detector: exact, for steady targets and Swerling's four cases, with any
 * number of non-coherently integrated pulses. Signal-to-noise ratios are those of a single pulse, averaged over the
 * fluctuation.
 */
public final class Detectability {
    private Detectability() {}

    /**
     * Probability that one look with a single pulse detects a target.
     *
     * @param signalToNoise signal-to-noise ratio, dB
     * @param falseAlarm probability of a false alarm, 1e-12 to 0.01
     * @param fluctuation fluctuation of the target
     */
    public static double probability(double signalToNoise, double falseAlarm, Fluctuation fluctuation) {
        return probability(signalToNoise, falseAlarm, fluctuation, 1);
    }

    /**
     * Probability that one look detects a target.
     *
     * @param signalToNoise signal-to-noise ratio of each pulse, dB
     * @param falseAlarm probability of a false alarm, 1e-12 to 0.01
     * @param fluctuation fluctuation of the target
     * @param pulses number of pulses integrated, 1 to 1000
     */
    public static double probability(double signalToNoise, double falseAlarm, Fluctuation fluctuation, int pulses) {
        return detector(falseAlarm, pulses).probability(signalToNoise, fluctuation);
    }

    /**
     * Signal-to-noise ratio required in one look with a single pulse, dB; minus infinity for a probability that noise
     * alone reaches.
     *
     * @param probability probability of detection, above 0 and below 1
     * @param falseAlarm probability of a false alarm, 1e-12 to 0.01
     * @param fluctuation fluctuation of the target
     */
    public static double required(double probability, double falseAlarm, Fluctuation fluctuation) {
        return required(probability, falseAlarm, fluctuation, 1);
    }

    /**
     * Signal-to-noise ratio required of each of several pulses, dB; minus infinity for a probability that noise alone
     * reaches.
     *
     * @param probability probability of detection, above 0 and below 1
     * @param falseAlarm probability of a false alarm, 1e-12 to 0.01
     * @param fluctuation fluctuation of the target
     * @param pulses number of pulses integrated, 1 to 1000
     */
    public static double required(double probability, double falseAlarm, Fluctuation fluctuation, int pulses) {
        return detector(falseAlarm, pulses).required(probability, fluctuation);
    }

    private static SquareLawDetector detector(double falseAlarm, int pulses) {
        Check.between("falseAlarm", falseAlarm, 1e-12, 0.01, Quantity.NUMBER);
        Check.between("pulses", pulses, 1, SquareLawDetector.MAX_PULSES, Quantity.NUMBER);
        return new SquareLawDetector(falseAlarm, pulses);
    }
}
