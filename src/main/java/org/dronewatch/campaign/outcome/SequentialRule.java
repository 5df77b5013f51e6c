package org.dronewatch.campaign.outcome;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.statistics.Proportion;

/**
 * Decides when a sequence of cases is long enough: Chen's rule (X. Chen, Sequential Analysis 31, 2012, as applied by
 * Jegourel, Sun and Dong, ACM Transactions on Modeling and Computer Simulation 29, 2019). If a fraction s of n cases
 * has the outcome, the sequence stops as soon as (|s - 1/2| - 2h/3)^2 is at least 1/4 - n h^2 / (2 ln(2/d)), for the
 * half-width h and the confidence 1 - d. The interval from s - h to s + h then contains the probability with at least
 * that confidence, although the number of cases depends on their outcomes. Testing an ordinary interval after every
 * case would not ensure that.
 *
 * @param halfWidth half the width of the interval, 0.002 to 0.5
 * @param confidence confidence of the interval, 0.5 to 0.999
 */
public record SequentialRule(
        @In(value = Quantity.NUMBER, from = 0.002, to = 0.5) double halfWidth,
        @In(value = Quantity.NUMBER, from = 0.5, to = 0.999) double confidence) {
    /** The default confidence. */
    public static final double CONFIDENCE = 0.95;

    /** Checks the limits. */
    public SequentialRule {
        Limits.check(SequentialRule.class, halfWidth, confidence);
    }

    /** A rule with a confidence of 95 %. */
    @Defaults("halfWidth")
    public static SequentialRule of(double halfWidth) {
        return new SequentialRule(halfWidth, CONFIDENCE);
    }

    /** Whether a sequence is long enough; false without cases. */
    public boolean stops(Proportion sofar) {
        return sofar.of() > 0 && stops(sofar.share(), sofar.of());
    }

    /** The condition for a share that need not be a whole number of the cases. */
    boolean stops(double share, int cases) {
        double distance = Math.abs(share - 0.5) - 2.0 / 3.0 * halfWidth;
        return distance * distance >= 0.25 - cases * halfWidth * halfWidth / (2.0 * logarithm());
    }

    /**
     * The largest number of cases that the rule can take: the number that, fixed beforehand, would give the interval
     * its confidence for any probability (Okamoto, Annals of the Institute of Statistical Mathematics 10, 1959).
     */
    public int most() {
        return (int) Math.ceil(logarithm() / (2.0 * halfWidth * halfWidth));
    }

    private double logarithm() {
        return StrictMath.log(2.0 / (1.0 - confidence));
    }

    /** The interval for the probability once the rule has stopped. */
    public Proportion.Interval interval(Proportion proportion) {
        double share = proportion.share();
        return new Proportion.Interval(Math.max(0.0, share - halfWidth), Math.min(1.0, share + halfWidth));
    }
}
