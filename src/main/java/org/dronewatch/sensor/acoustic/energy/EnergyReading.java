package org.dronewatch.sensor.acoustic.energy;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntToDoubleFunction;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;

/**
 * The result of one look of an acoustic sensor at one drone, in the energy model. Energies are per octave band and
 * relative to the square of a sound pressure of 20 uPa, so that {@code 10 lg} of each is a sound pressure level.
 *
 * @param direct energy on the straight path, including transmission through walls; exact
 * @param diffracted energy diffracted around the edges of the obstacles that hide the drone
 * @param mirrored energy on paths of specular reflections alone; exact
 * @param reverberant energy on all other paths; estimated
 * @param traced number of ray segments that were traced
 * @param standardError standard error of the level on which detection is based, from the scatter among rays, dB
 * @param isConverged whether the level rests on more than a few rays; false for silence, since rays may have missed the
 *     only path
 * @param audit energy balance of the rays
 * @param decay decay of the sound
 */
public record EnergyReading(
        List<Double> direct,
        List<Double> diffracted,
        List<Double> mirrored,
        List<Double> reverberant,
        long traced,
        double standardError,
        boolean isConverged,
        EnergyAudit audit,
        DecayCurve decay) {

    /** Copies the lists. */
    public EnergyReading {
        direct = List.copyOf(direct);
        diffracted = List.copyOf(diffracted);
        mirrored = List.copyOf(mirrored);
        reverberant = List.copyOf(reverberant);
    }

    /**
     * This reading, without the contribution of rays if too few contributed: the exact paths alone. The standard error
     * remains that of the whole: these paths are exact, but it is uncertain how much of the total sound they carry.
     */
    public EnergyReading settled() {
        return isConverged ? this : SettingsForm.with(this, "reverberant", Collections.nCopies(OctaveBands.COUNT, 0.0));
    }

    /** Energy in a band, relative to the square of 20 uPa. */
    public double energy(int band) {
        return direct.get(band) + diffracted.get(band) + mirrored.get(band) + reverberant.get(band);
    }

    /** Sound pressure level in a band, dB; minus infinity for silence. */
    public double level(int band) {
        return Levels.ofRatio(energy(band));
    }

    /** Total sound pressure level of all bands, dB. */
    public double totalLevel() {
        double energy = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            energy += energy(band);
        }
        return Levels.ofRatio(energy);
    }

    /** A-weighted total sound pressure level, dB. */
    public double aWeightedLevel() {
        return aWeighted(this::energy);
    }

    /**
     * A-weighted level of the direct and diffracted sound, dB; with {@code ground: coherent}, the reflection from the
     * ground is part of the direct sound, with which it interferes.
     */
    public double directLevel() {
        return aWeighted(band -> direct.get(band) + diffracted.get(band));
    }

    /** A-weighted level of all reflected sound, dB. */
    public double reverberantLevel() {
        return aWeighted(band -> mirrored.get(band) + reverberant.get(band));
    }

    private static double aWeighted(IntToDoubleFunction energies) {
        double energy = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            energy += energies.applyAsDouble(band) * Levels.toRatio(OctaveBands.aWeight(band));
        }
        return Levels.ofRatio(energy);
    }

    /** The band in which this sound is highest above a background. */
    public int bestBand(BandLevels background) {
        int best = 0;
        for (int band = 1; band < OctaveBands.COUNT; band++) {
            if (level(band) - background.level(band) > level(best) - background.level(best)) {
                best = band;
            }
        }
        return best;
    }

    /**
     * The figures for reports, by names that include their units: levels, signal-to-noise ratios, rays and standard
     * error. Where nothing was heard, no error is stated.
     */
    public Map<String, Double> figures(BandLevels background) {
        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("direct_db", directLevel());
        figures.put("reverberant_db", reverberantLevel());
        figures.put("rays_traced", (double) traced);
        if (totalLevel() > Double.NEGATIVE_INFINITY) {
            figures.put("standard_error_db", standardError);
        }
        figures.put("converged", isConverged ? 1.0 : 0.0);
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            figures.put("level_" + OctaveBands.nominal(band) + "hz_db", level(band));
        }
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            figures.put("snr_" + OctaveBands.nominal(band) + "hz_db", level(band) - background.level(band));
        }
        return figures;
    }
}
