package org.dronewatch.sound;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The sound of a type of drone.
 *
 * @param name its name in the table, or any name for a sound that is not in it
 * @param level A-weighted sound power level, dB re 1 pW
 * @param shape A-weighted level of each octave band relative to the highest of these levels, dB
 * @param basis whether the spectrum was measured or is assumed
 * @param source source of the figures
 */
public record DroneSound(String name, double level, List<Double> shape, Basis basis, String source) {

    /** How the figures of a sound were obtained. */
    public enum Basis {
        /** Measured, as the source states. */
        MEASURED,
        /** Assumed, as the source explains. */
        ASSUMED
    }

    /** Copies the list: later changes by the caller have no effect. */
    public DroneSound {
        shape = List.copyOf(shape);
        if (shape.size() != OctaveBands.COUNT) {
            throw new IllegalArgumentException("spectrum '" + name + "' has " + shape.size() + " bands but needs 8");
        }
    }

    /**
     * Sound power levels by octave band without weighting, dB re 1 pW, of this spectrum at a given total level.
     *
     * @param aWeighted A-weighted sound power level of all bands together, dB re 1 pW
     */
    public List<Double> octaves(double aWeighted) {
        return octaves(shape, aWeighted);
    }

    /**
     * Sound power levels by octave band without weighting, dB re 1 pW.
     *
     * @param shape A-weighted levels of the eight bands relative to one another, dB
     * @param aWeighted A-weighted sound power level of all bands together, dB re 1 pW
     */
    public static List<Double> octaves(List<Double> shape, double aWeighted) {
        double all = Levels.sum(shape.stream().mapToDouble(Double::doubleValue).toArray());
        List<Double> levels = new ArrayList<>();
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            levels.add(aWeighted + shape.get(band) - all - OctaveBands.aWeight(band));
        }
        return levels;
    }

    /**
     * A sound from the sound power levels of its octave bands, as reported by a measurement to ISO 3744.
     *
     * @param name any name
     * @param power levels without weighting, dB re 1 pW
     * @param basis whether they were measured or are assumed
     * @param source source of the levels
     */
    public static DroneSound of(String name, BandLevels power, Basis basis, String source) {
        double[] weighted = power.toArray();
        for (int band = 0; band < weighted.length; band++) {
            weighted[band] += OctaveBands.aWeight(band);
        }
        double loudest = Arrays.stream(weighted).max().orElseThrow();
        List<Double> shape =
                Arrays.stream(weighted).map(level -> level - loudest).boxed().toList();
        return new DroneSound(name, power.aWeighted(), shape, basis, source);
    }
}
