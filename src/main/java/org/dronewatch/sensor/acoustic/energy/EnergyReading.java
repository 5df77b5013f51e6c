package org.dronewatch.sensor.acoustic.energy;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;

/**
 * What one look of an acoustic sensor gave for one drone, in the energy model. Energies are per octave band and relative
 * to a sound pressure of 20 uPa squared, so that {@code 10 lg} of them are sound pressure levels.
 *
 * @param direct by the direct path, exact
 * @param mirrored by single mirror reflections, exact
 * @param reverberant by all that comes later, estimated
 * @param standardError of the level of all together, dB, from the scatter among rays
 * @param audit where the rays' energy went
 * @param decay how the sound dies away
 */
public record EnergyReading(
        List<Double> direct,
        List<Double> mirrored,
        List<Double> reverberant,
        double standardError,
        EnergyAudit audit,
        DecayCurve decay) {

    /** Keeps its own lists. */
    public EnergyReading {
        direct = List.copyOf(direct);
        mirrored = List.copyOf(mirrored);
        reverberant = List.copyOf(reverberant);
    }

    /** Sound pressure level in a band, dB; minus infinity for silence. */
    public double level(int band) {
        return Levels.ofRatio(direct.get(band) + mirrored.get(band) + reverberant.get(band));
    }

    /** Sound pressure level of all bands together, dB. */
    public double totalLevel() {
        double energy = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            energy += Levels.toRatio(level(band));
        }
        return Levels.ofRatio(energy);
    }

    /** A-weighted sound pressure level of all bands together, dB. */
    public double aWeightedLevel() {
        double energy = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            energy += Levels.toRatio(level(band) + OctaveBands.aWeight(band));
        }
        return Levels.ofRatio(energy);
    }

    /** The figures for reports, by name with unit. */
    public Map<String, Double> figures() {
        Map<String, Double> figures = new LinkedHashMap<>();
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            figures.put("level_" + OctaveBands.nominal(band) + "hz_db", level(band));
        }
        figures.put("standard_error_db", standardError);
        return figures;
    }
}
