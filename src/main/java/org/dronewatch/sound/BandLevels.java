package org.dronewatch.sound;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InOrder;
import org.dronewatch.setting.OneForAll;
import org.dronewatch.setting.Quantity;

/**
 * A spectrum: one level for each octave band, dB, relative to a reference that depends on where the spectrum is used.
 * Every level is finite and, in a scene's settings, -200 to 200 dB; silence is written as a very low level, such as
 * -200 dB. In a scene file, a spectrum is written as eight numbers, or as one number for all bands.
 *
 * @param hz63 level of the band at 63 Hz, dB; -200 to 200 in a scene file
 * @param hz125 level of the band at 125 Hz, dB; -200 to 200 in a scene file
 * @param hz250 level of the band at 250 Hz, dB; -200 to 200 in a scene file
 * @param hz500 level of the band at 500 Hz, dB; -200 to 200 in a scene file
 * @param hz1000 level of the band at 1 kHz, dB; -200 to 200 in a scene file
 * @param hz2000 level of the band at 2 kHz, dB; -200 to 200 in a scene file
 * @param hz4000 level of the band at 4 kHz, dB; -200 to 200 in a scene file
 * @param hz8000 level of the band at 8 kHz, dB; -200 to 200 in a scene file
 */
@InOrder
@OneForAll
public record BandLevels(
        @In(value = Quantity.LEVEL, from = -BandLevels.MOST, to = BandLevels.MOST) double hz63,
        @In(value = Quantity.LEVEL, from = -BandLevels.MOST, to = BandLevels.MOST) double hz125,
        @In(value = Quantity.LEVEL, from = -BandLevels.MOST, to = BandLevels.MOST) double hz250,
        @In(value = Quantity.LEVEL, from = -BandLevels.MOST, to = BandLevels.MOST) double hz500,
        @In(value = Quantity.LEVEL, from = -BandLevels.MOST, to = BandLevels.MOST) double hz1000,
        @In(value = Quantity.LEVEL, from = -BandLevels.MOST, to = BandLevels.MOST) double hz2000,
        @In(value = Quantity.LEVEL, from = -BandLevels.MOST, to = BandLevels.MOST) double hz4000,
        @In(value = Quantity.LEVEL, from = -BandLevels.MOST, to = BandLevels.MOST) double hz8000) {

    /** The largest level of a band in a scene's settings, dB; its negative is the smallest. */
    public static final double MOST = 200.0;

    /**
     * Checks that there is a level for each band.
     *
     * @throws IllegalArgumentException when a level is not finite
     */
    public BandLevels {
        checkFinite(hz63, hz125, hz250, hz500, hz1000, hz2000, hz4000, hz8000);
    }

    private static void checkFinite(double... levels) {
        for (int band = 0; band < levels.length; band++) {
            if (!Double.isFinite(levels[band])) {
                String name = BandLevels.class.getRecordComponents()[band].getName();
                throw new IllegalArgumentException(name + " " + levels[band] + " dB must be finite");
            }
        }
    }

    /**
     * A spectrum of eight levels from 63 Hz to 8 kHz, dB.
     *
     * @throws IllegalArgumentException unless there are eight finite levels
     */
    public static BandLevels of(double... levels) {
        if (levels.length != OctaveBands.COUNT) {
            throw new IllegalArgumentException("a spectrum of " + levels.length
                    + " levels: there must be one for each of the " + OctaveBands.COUNT + " octave bands");
        }
        int band = 0;
        return new BandLevels(
                levels[band++],
                levels[band++],
                levels[band++],
                levels[band++],
                levels[band++],
                levels[band++],
                levels[band++],
                levels[band]);
    }

    /**
     * A spectrum from a list of eight levels, dB.
     *
     * @throws IllegalArgumentException unless there are eight finite levels
     */
    public static BandLevels of(List<Double> levels) {
        return of(levels.stream().mapToDouble(Double::doubleValue).toArray());
    }

    /** A spectrum with the same level in every band, dB. */
    public static BandLevels flat(double level) {
        double[] levels = new double[OctaveBands.COUNT];
        Arrays.fill(levels, level);
        return of(levels);
    }

    /**
     * The level of a band, dB.
     *
     * @param band 0 for 63 Hz to 7 for 8 kHz
     * @throws IndexOutOfBoundsException when there is no such band
     */
    public double level(int band) {
        return toArray()[band];
    }

    /** The total level of all bands, summed as incoherent sound, dB. */
    public double total() {
        return Levels.sum(toArray());
    }

    /** The total level of all bands with A-weighting (IEC 61672-1), dB(A). */
    public double aWeighted() {
        double[] levels = toArray();
        for (int band = 0; band < levels.length; band++) {
            levels[band] += OctaveBands.aWeight(band);
        }
        return Levels.sum(levels);
    }

    /** This spectrum with a gain added to every band, dB. */
    public BandLevels plus(double gain) {
        return mapped(level -> level + gain);
    }

    /** The sum of this sound and another one that is incoherent with it, band by band. */
    public BandLevels energySumWith(BandLevels other) {
        double[] levels = toArray();
        for (int band = 0; band < levels.length; band++) {
            levels[band] = Levels.sum(levels[band], other.level(band));
        }
        return of(levels);
    }

    /** The levels from 63 Hz to 8 kHz, dB; a new array each time. */
    public double[] toArray() {
        return new double[] {hz63, hz125, hz250, hz500, hz1000, hz2000, hz4000, hz8000};
    }

    private BandLevels mapped(DoubleUnaryOperator change) {
        return of(Arrays.stream(toArray()).map(change).toArray());
    }
}
