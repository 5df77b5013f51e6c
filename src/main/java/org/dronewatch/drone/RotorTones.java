package org.dronewatch.drone;

import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.NarrowBand;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.Tone;

/**
 * The tones of a drone: the blade-passing frequency of its rotors and the harmonics of that frequency. They are part of
 * the drone's sound power, not additional to it; the rest of each octave band is broadband noise.
 *
 * @param rotorSpeed rate of rotation of a rotor, above 0 and at most 1000 Hz; also in {@code rpm}, as in
 *     {@code 6150 rpm}
 * @param blades number of blades of a rotor, 1 to 12; two on most quadrotors
 * @param shares the fraction of its octave band's power that each tone has, starting with the tone at the blade-passing
 *     frequency, 0 to 1; up to 50 tones, and those within one octave band add up to at most 1. Tones outside the eight
 *     octave bands are not heard
 */
public record RotorTones(
        @In(value = Quantity.FREQUENCY, above = 0, to = 1000) double rotorSpeed,
        @In(value = Quantity.NUMBER, from = 1, to = 12) int blades,
        @In(value = Quantity.RATIO, from = 0, to = 1) List<Double> shares) {
    /**
     * Typical fractions: half of the power for the tone at the blade-passing frequency, and less for each harmonic.
     * Assumed.
     */
    private static final List<Double> TYPICAL = List.of(0.5, 0.25, 0.25, 0.1, 0.1, 0.1);

    private static final int MAX_LINES = 50;
    private static final double ROUNDING = 1e-9;

    /**
     * Checks the limits and copies the list.
     *
     * @throws IllegalArgumentException if a value is out of range, or the tones in an octave band have more than its
     *     whole power
     */
    public RotorTones {
        Limits.check(RotorTones.class, rotorSpeed, blades, shares);
        shares = List.copyOf(shares);
        if (shares.isEmpty() || shares.size() > MAX_LINES) {
            throw new IllegalArgumentException(
                    "shares has " + shares.size() + " values but must have 1 to " + MAX_LINES);
        }
        double[] inOctave = new double[OctaveBands.COUNT];
        for (Tone line : lines(rotorSpeed * blades, shares)) {
            NarrowBand.ofLine(line.frequency(), 0.0).ifPresent(band -> inOctave[band.octave()] += line.share());
        }
        for (int band = 0; band < inOctave.length; band++) {
            if (inOctave[band] > 1.0 + ROUNDING) {
                throw new IllegalArgumentException(
                        "shares of the tones in the octave band at " + OctaveBands.nominal(band) + " Hz add up to "
                                + Quantity.RATIO.inBrief(inOctave[band]) + " but must add up to at most 1");
            }
        }
    }

    /**
     * The six tones of rotors with two blades: the tone at the blade-passing frequency has half of the power of the
     * octave band in which it lies, and each harmonic a smaller fraction. These fractions are assumed.
     */
    @Defaults("rotorSpeed")
    public static RotorTones of(double rotorSpeed) {
        return new RotorTones(rotorSpeed, 2, TYPICAL);
    }

    /** These tones with another number of blades. */
    public RotorTones withBlades(int number) {
        return SettingsForm.with(this, "blades", number);
    }

    /** These tones with other fractions of the octave bands' power. */
    public RotorTones withShares(List<Double> fractions) {
        return SettingsForm.with(this, "shares", fractions);
    }

    /** The blade-passing frequency, Hz. */
    public double bladePassingFrequency() {
        return rotorSpeed * blades;
    }

    /** The tones, starting with the one at the blade-passing frequency. */
    public List<Tone> lines() {
        return lines(bladePassingFrequency(), shares);
    }

    private static List<Tone> lines(double fundamental, List<Double> shares) {
        return IntStream.rangeClosed(1, shares.size())
                .mapToObj(harmonic -> new Tone(harmonic, harmonic * fundamental, shares.get(harmonic - 1)))
                .toList();
    }
}
