package org.dronewatch.sound;

import java.util.List;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.OneForAll;
import org.dronewatch.setting.Quantity;

/**
 * A fraction for each octave band, such as the fraction of sound that a surface absorbs. In a scene file, the fractions
 * are written as eight numbers, or as one number for all bands.
 *
 * @param hz63 fraction in the band at 63 Hz, 0 to 1
 * @param hz125 fraction in the band at 125 Hz, 0 to 1
 * @param hz250 fraction in the band at 250 Hz, 0 to 1
 * @param hz500 fraction in the band at 500 Hz, 0 to 1
 * @param hz1000 fraction in the band at 1 kHz, 0 to 1
 * @param hz2000 fraction in the band at 2 kHz, 0 to 1
 * @param hz4000 fraction in the band at 4 kHz, 0 to 1
 * @param hz8000 fraction in the band at 8 kHz, 0 to 1
 */
@OneForAll
public record BandFractions(
        @In(value = Quantity.RATIO, from = 0, to = 1) double hz63,
        @In(value = Quantity.RATIO, from = 0, to = 1) double hz125,
        @In(value = Quantity.RATIO, from = 0, to = 1) double hz250,
        @In(value = Quantity.RATIO, from = 0, to = 1) double hz500,
        @In(value = Quantity.RATIO, from = 0, to = 1) double hz1000,
        @In(value = Quantity.RATIO, from = 0, to = 1) double hz2000,
        @In(value = Quantity.RATIO, from = 0, to = 1) double hz4000,
        @In(value = Quantity.RATIO, from = 0, to = 1) double hz8000) {

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a fraction is outside 0 to 1
     */
    public BandFractions {
        Limits.check(BandFractions.class, hz63, hz125, hz250, hz500, hz1000, hz2000, hz4000, hz8000);
    }

    /** Fractions that are the same in every band, 0 to 1. */
    public static BandFractions flat(double fraction) {
        return new BandFractions(fraction, fraction, fraction, fraction, fraction, fraction, fraction, fraction);
    }

    /**
     * Eight fractions from 63 Hz to 8 kHz, 0 to 1.
     *
     * @throws IllegalArgumentException unless there are eight, each from 0 to 1
     */
    public static BandFractions of(double... fractions) {
        if (fractions.length != OctaveBands.COUNT) {
            throw new IllegalArgumentException(fractions.length + " fractions: there must be one for each of the "
                    + OctaveBands.COUNT + " octave bands");
        }
        int band = 0;
        return new BandFractions(
                fractions[band++],
                fractions[band++],
                fractions[band++],
                fractions[band++],
                fractions[band++],
                fractions[band++],
                fractions[band++],
                fractions[band]);
    }

    /** The fractions from 63 Hz to 8 kHz. */
    public List<Double> toList() {
        return List.of(hz63, hz125, hz250, hz500, hz1000, hz2000, hz4000, hz8000);
    }
}
