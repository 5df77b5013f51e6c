package org.dronewatch.campaign.outcome;

import java.util.Optional;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * How precisely a probability is to be known: cases are run until it is known with this precision.
 *
 * @param of the outcome whose probability is to be known
 * @param variant the variant; may be omitted if there is only one
 * @param halfWidth half the width of the interval, 0.002 to 0.5
 * @param confidence confidence of the interval, 0.5 to 0.999
 */
public record UntilSettings(
        Outcome of,
        Optional<String> variant,
        @In(value = Quantity.NUMBER, from = 0.002, to = 0.5) double halfWidth,
        @In(value = Quantity.NUMBER, from = 0.5, to = 0.999) double confidence) {
    /** Checks the limits. */
    public UntilSettings {
        Check.present("variant", variant);
        Limits.check(UntilSettings.class, of, variant, halfWidth, confidence);
    }

    /** An outcome of the only variant, with a confidence of 95 %. */
    @Defaults({"of", "halfWidth"})
    public static UntilSettings of(Outcome of, double halfWidth) {
        return new UntilSettings(of, Optional.empty(), halfWidth, SequentialRule.CONFIDENCE);
    }

    /** The rule that decides when the probability is known precisely enough. */
    public SequentialRule rule() {
        return new SequentialRule(halfWidth, confidence);
    }
}
