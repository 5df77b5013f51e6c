package org.dronewatch.sound.surface;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.sound.BandFractions;

/**
 * The absorption of a surface at one angle of incidence.
 *
 * @param angle angle between the direction of the sound and the surface's normal, 0 to pi/2 rad
 * @param absorption fraction that is not reflected, 0 to 1: eight octave bands, or one number
 */
public record AbsorptionAtAngle(
        @In(value = Quantity.ANGLE, from = 0, to = Math.PI / 2) double angle, BandFractions absorption) {

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if the angle is out of range
     */
    public AbsorptionAtAngle {
        Limits.check(AbsorptionAtAngle.class, angle, absorption);
    }
}
