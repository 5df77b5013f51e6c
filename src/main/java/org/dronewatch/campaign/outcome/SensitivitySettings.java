package org.dronewatch.campaign.outcome;

import java.util.Optional;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * How to determine which of the settings that vary matter, and which do not.
 *
 * @param method the method; {@code none} to switch it off
 * @param base number of groups of further cases, 2 to 100,000
 * @param output the quantity whose variation is to be explained
 * @param variant the variant; the first by default
 */
public record SensitivitySettings(
        Method method,
        @In(value = Quantity.NUMBER, from = 2, to = 1e5) int base,
        CampaignQuantity output,
        Optional<String> variant) {
    private static final int BASE = 512;

    /** How the influence of a setting is measured. */
    public enum Method {
        /** Not at all. */
        NONE,
        /** By elementary effects, each group having one case more than there are factors. */
        MORRIS,
        /** By fractions of the variance, each group having two cases more than there are factors. */
        SOBOL
    }

    /** Checks the limits. */
    public SensitivitySettings {
        Check.present("variant", variant);
        Limits.check(SensitivitySettings.class, method, base, output, variant);
    }

    /** The sensitivity of the warning time of the first variant, with 512 groups. */
    @Defaults("method")
    public static SensitivitySettings of(Method method) {
        return new SensitivitySettings(method, BASE, CampaignQuantity.WARNING_S, Optional.empty());
    }
}
