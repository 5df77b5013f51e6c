package org.dronewatch.scenario.advice;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronewatch.geo.Origin;
import org.dronewatch.setting.Quantity;

/**
 * Warns about a latitude or longitude that was probably written without a unit, and is therefore taken as radians.
 *
 * @param origin geographic position of the scene's origin
 */
public record OriginAdvice(Origin origin) {
    /** Gives one line for each coordinate that was probably written without a unit. */
    public void giveTo(Consumer<String> target) {
        giveTo("latitude", origin.latitude(), target);
        giveTo("longitude", origin.longitude(), target);
    }

    private static void giveTo(String name, double value, Consumer<String> target) {
        Quantity.ANGLE
                .bare(value)
                .ifPresent(written -> target.accept(String.format(
                        Locale.ROOT,
                        "world.origin.%s is %s; for degrees, write %s deg",
                        name,
                        Quantity.ANGLE.inWords(value),
                        written)));
    }
}
