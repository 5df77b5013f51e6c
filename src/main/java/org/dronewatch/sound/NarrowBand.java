package org.dronewatch.sound;

import java.util.Optional;

/**
 * The band in which a tone is searched for: as wide as the tone, within one octave band.
 *
 * @param frequency its centre frequency, Hz
 * @param width its width, Hz, above 0 and at most that of the octave band
 * @param octave the octave band in which its centre lies, 0 for 63 Hz to 7 for 8 kHz
 */
public record NarrowBand(double frequency, double width, int octave) {
    /** Standard deviation of a hovering drone's rotor speed in still air, relative (Heutschi and others 2020). */
    private static final double JITTER = 0.005;

    /** The increase of this jitter for each metre per second of wind, s/m. */
    private static final double JITTER_BY_WIND = 0.0052;

    /** Decades from the middle of an octave band to its edges (IEC 61260-1, base ten). */
    private static final double HALF_OCTAVE = 0.15;

    /**
     * The band of a tone. The rotors of a drone do not turn quite steadily, least of all in wind: the relative jitter
     * of their speed, 0.5 % plus 0.52 % for each m/s of wind, is the relative width of all their tones (Heutschi and
     * others, Acta Acustica 4, 24, 2020, at a height of 10 m).
     *
     * @param frequency frequency of the tone, Hz
     * @param wind wind speed, m/s, 0 or more
     * @return empty outside the octave bands from 63 Hz to 8 kHz
     */
    public static Optional<NarrowBand> ofLine(double frequency, double wind) {
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            if (frequency >= edge(band, -HALF_OCTAVE) && frequency < edge(band, HALF_OCTAVE)) {
                double width = frequency * (JITTER + JITTER_BY_WIND * wind);
                return Optional.of(new NarrowBand(frequency, Math.min(width, octaveWidth(band)), band));
            }
        }
        return Optional.empty();
    }

    /** The fraction of its octave band that this band covers, above 0 and at most 1. */
    public double fraction() {
        return width / octaveWidth(octave);
    }

    /**
     * The level of noise with a flat spectrum in the octave band minus its level in this band, dB:
     * {@code 10 lg(B_octave / B)}, with the widths of the two bands.
     */
    public double gain() {
        return -Levels.ofRatio(fraction());
    }

    /** The width of an octave band, Hz. */
    static double octaveWidth(int band) {
        return edge(band, HALF_OCTAVE) - edge(band, -HALF_OCTAVE);
    }

    private static double edge(int band, double decades) {
        return OctaveBands.midband(band) * Math.pow(10.0, decades);
    }
}
