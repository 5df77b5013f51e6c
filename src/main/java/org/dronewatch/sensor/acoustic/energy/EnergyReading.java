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
 * The result of one look of an acoustic sensor at one drone, in the energy model. Energies are mean-square sound
 * pressures by octave band, relative to (20 uPa)^2, so that {@code 10 lg} of each is a sound pressure level.
 *
 * @param direct energy on the straight path, including transmission through walls; exact
 * @param diffracted energy diffracted around the edges of the obstacles that hide the drone
 * @param mirrored energy on paths of specular reflections alone; exact
 * @param reverberant energy on all other paths; estimated
 * @param traced number of ray segments that were traced
 * @param standardError standard error of the level on which detection is based, from the scatter among rays, dB; 0 for
 *     silence
 * @param isConverged whether exact paths or enough rays determine the level; false if nothing is heard of a source that
 *     emits sound, since rays may have missed the only path
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
     * This reading or, if too few rays contributed, its exact paths alone. The standard error remains that of the whole
     * reading: the paths are exact, but it is uncertain how much of the total sound they carry.
     */
    public EnergyReading forDetection() {
        return isConverged ? this : SettingsForm.with(this, "reverberant", Collections.nCopies(OctaveBands.COUNT, 0.0));
    }

    /**
     * Mean-square sound pressure in a band, relative to (20 uPa)^2.
     *
     * @param band 0 for 63 Hz to 7 for 8 kHz
     */
    public double energy(int band) {
        return direct.get(band) + diffracted.get(band) + mirrored.get(band) + reverberant.get(band);
    }

    /**
     * Sound pressure level in a band, dB re 20 uPa; minus infinity for silence.
     *
     * @param band 0 for 63 Hz to 7 for 8 kHz
     */
    public double level(int band) {
        return Levels.ofRatio(energy(band));
    }

    /** Total sound pressure level of all bands, without weighting, dB re 20 uPa. */
    public double totalLevel() {
        double energy = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            energy += energy(band);
        }
        return Levels.ofRatio(energy);
    }

    /** A-weighted total sound pressure level, dB re 20 uPa. */
    public double aWeightedLevel() {
        return aWeighted(this::energy);
    }

    /**
     * A-weighted level of the direct and diffracted sound, dB re 20 uPa. The direct sound includes the reflection from
     * the ground in two cases only: with {@code ground: coherent}, unless other reflections carry more energy; and
     * where the air bends the paths.
     */
    public double directLevel() {
        return aWeighted(band -> direct.get(band) + diffracted.get(band));
    }

    /** A-weighted level of all other sound, dB re 20 uPa: specular reflections, and sound that was scattered. */
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

    /** The octave band in which this sound is highest above a background: 0 for 63 Hz to 7 for 8 kHz. */
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
