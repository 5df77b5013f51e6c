package org.dronewatch.scenario.advice;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import java.util.function.Consumer;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.ClearSky;
import org.dronewatch.world.Light;

/**
 * Warns about a site's light if its illuminance is one that no weather causes at the sun's elevation.
 *
 * @param light light of the site
 */
public record LightAdvice(Light light) {
    /** The thickest clouds leave this fraction of the light of a clear sky: assumed. */
    private static final double DARKEST = 0.005;

    /** Bright clouds beside the sun add to its light; in twilight, one degree changes the light by a factor of 3. */
    private static final double BRIGHTEST = 1.5;

    private static final double BRIGHTEST_IN_TWILIGHT = 3.0;

    /** The illuminance of the darkest night that can be set, lx. */
    private static final double DARKEST_NIGHT = 1e-5;

    /** A full moon at the zenith, lx (Seidelmann, ed., Explanatory Supplement to the Astronomical Almanac, 1992). */
    private static final double MOON = 0.27;

    /** Gives a warning line if the illuminance does not fit the sun's elevation. */
    public void giveTo(Consumer<String> target) {
        light.sun().ifPresent(sun -> {
            double clear = ClearSky.illuminance(sun.elevation());
            boolean isSet = sun.elevation() < 0.0;
            double low = Math.max(DARKEST_NIGHT, DARKEST * clear);
            double high = (isSet ? BRIGHTEST_IN_TWILIGHT : BRIGHTEST) * clear + MOON;
            if (light.illuminance() < low || light.illuminance() > high) {
                target.accept(String.format(
                        Locale.ROOT,
                        "world.light.illuminance %s is implausible with the sun %.3g degrees %s the horizon: the"
                                + " natural range at this elevation is %s to %s; the illuminance and the sun's"
                                + " elevation are used as stated",
                        Quantity.ILLUMINANCE.inWords(light.illuminance()),
                        Math.abs(Math.toDegrees(sun.elevation())),
                        isSet ? "below" : "above",
                        Quantity.ILLUMINANCE.inWords(rounded(low)),
                        Quantity.ILLUMINANCE.inWords(rounded(high))));
            }
        });
    }

    /** A value, rounded to two digits. */
    private static double rounded(double value) {
        return new BigDecimal(value).round(new MathContext(2)).doubleValue();
    }
}
