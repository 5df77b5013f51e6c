package org.dronewatch.sound;

import org.dronewatch.setting.Check;
import org.dronewatch.setting.Quantity;

/**
 * An acoustic medium, treated as a fluid: solids carry longitudinal waves only.
 *
 * @param name its name in the table
 * @param density density, above 0, kg/m3
 * @param speed speed of sound, above 0, m/s
 * @param source source of the figures
 */
public record Medium(String name, double density, double speed, String source) {

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException when density or speed is not above 0 and finite, or a text is missing
     */
    public Medium {
        Check.present("name", name);
        Check.positive("density in kg/m3 of medium '" + name + "'", density, Quantity.NUMBER);
        Check.positive("speed of medium '" + name + "'", speed, Quantity.SPEED);
        Check.present("source", source);
    }

    /** Characteristic impedance: density times speed, Pa s/m. */
    public double impedance() {
        return density * speed;
    }
}
