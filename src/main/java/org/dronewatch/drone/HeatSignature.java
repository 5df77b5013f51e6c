package org.dronewatch.drone;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * A drone's thermal signature.
 *
 * @param excess apparent temperature difference from its background while its motors run, averaged over its silhouette,
 *     -100 to 1000 K; negative if the drone is colder
 * @param coolingTime time in which the excess falls to 37 % with the motors off, above 0 and at most 10,000 s
 */
public record HeatSignature(
        @In(value = Quantity.TEMPERATURE_DIFFERENCE, from = -100, to = 1000) double excess,
        @In(value = Quantity.DURATION, above = 0, to = 10_000) double coolingTime) {
    /** A signature of 5 K, with a cooling time of two minutes; both are assumed. */
    @Defaults
    public static final HeatSignature DEFAULT = new HeatSignature(5.0, 120.0);

    /** Checks the limits. */
    public HeatSignature {
        Limits.check(HeatSignature.class, excess, coolingTime);
    }

    /** This signature with another temperature excess, K. */
    public HeatSignature withExcess(double kelvins) {
        return SettingsForm.with(this, "excess", kelvins);
    }

    /**
     * The excess after a time with the motors off, by Newton's law of cooling, K.
     *
     * @param seconds time since the motors were stopped, s; 0 while they run
     */
    public double after(double seconds) {
        return excess * Math.exp(-seconds / coolingTime);
    }
}
