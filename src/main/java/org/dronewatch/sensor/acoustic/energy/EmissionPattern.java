package org.dronewatch.sensor.acoustic.energy;

import java.util.EnumMap;
import java.util.Map;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;

/**
 * A directivity as a table that is cheap to read for each ray: energy factors as a function of the sine of the
 * elevation, interpolated linearly. Steps are fine enough for 0.01 dB.
 */
final class EmissionPattern {
    private static final int BANDS = OctaveBands.COUNT;
    private static final int STEPS = 512;
    private static final Map<Directivity, EmissionPattern> ALL = new EnumMap<>(Directivity.class);

    static {
        for (Directivity directivity : Directivity.values()) {
            ALL.put(directivity, new EmissionPattern(directivity));
        }
    }

    private final double[] factors = new double[(STEPS + 2) * BANDS];

    private EmissionPattern(Directivity directivity) {
        for (int step = 0; step < STEPS + 2; step++) {
            double elevation = Math.asin(Math.min(1.0, (double) step / STEPS));
            for (int band = 0; band < BANDS; band++) {
                factors[step * BANDS + band] = Levels.toRatio(directivity.index(band, elevation));
            }
        }
    }

    static EmissionPattern of(Directivity directivity) {
        return ALL.get(directivity);
    }

    /**
     * The factor of a band.
     *
     * @param rise sine of the elevation at which sound leaves, -1 to 1; its sign has no effect
     */
    double factor(int band, double rise) {
        double at = Math.min(1.0, Math.abs(rise)) * STEPS;
        int step = (int) at;
        double fraction = at - step;
        return (1.0 - fraction) * factors[step * BANDS + band] + fraction * factors[(step + 1) * BANDS + band];
    }
}
