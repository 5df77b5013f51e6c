package org.dronewatch.sensor.rf;

import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * A band in which other transmitters, such as WLAN or phones, intermittently raise the noise of a receiver.
 *
 * @param density power density received by an antenna of 0 dBi while the other transmitters are on, -200 to 50 dBm per
 *     MHz
 * @param occupancy fraction of the looks during which the other transmitters are on, 0 to 1
 * @param band the band
 * @param minFrequency lower edge in place of that of {@code band}, 1e6 to 1e11 Hz (1 MHz to 100 GHz)
 * @param maxFrequency upper edge in place of that of {@code band}, above the lower edge and at most 1e11 Hz
 */
public record OccupiedBand(
        @In(value = Quantity.LEVEL, from = -200, to = 50) double density,
        @In(value = Quantity.RATIO, from = 0, to = 1) double occupancy,
        RadioBand band,
        @In(value = Quantity.FREQUENCY, from = 1e6, to = 1e11) Optional<Double> minFrequency,
        @In(value = Quantity.FREQUENCY, from = 1e6, to = 1e11) Optional<Double> maxFrequency) {
    private static final double MEGAHERTZ = 1e6;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public OccupiedBand {
        Limits.check(OccupiedBand.class, density, occupancy, band, minFrequency, maxFrequency);
        double lowest = minFrequency.orElse(band.minFrequency());
        double highest = maxFrequency.orElse(band.maxFrequency());
        if (lowest >= highest) {
            throw new IllegalArgumentException(
                    "minFrequency " + lowest + " Hz must be below maxFrequency " + highest + " Hz");
        }
    }

    /** The 2.4 GHz band, with the given power density, dBm per MHz, and occupancy, 0 to 1. */
    @Defaults({"density", "occupancy"})
    public static OccupiedBand of(double density, double occupancy) {
        return new OccupiedBand(density, occupancy, RadioBand.ISM_2400, Optional.empty(), Optional.empty());
    }

    /** These transmitters in another band. */
    public OccupiedBand withBand(RadioBand other) {
        return SettingsForm.with(this, "band", other);
    }

    /** Whether a frequency, Hz, lies in this band. */
    boolean contains(double frequency) {
        return frequency >= lowest() && frequency <= highest();
    }

    /** Whether this band shares frequencies with another one. */
    boolean overlaps(OccupiedBand other) {
        return lowest() <= other.highest() && other.lowest() <= highest();
    }

    private double lowest() {
        return minFrequency.orElse(band.minFrequency());
    }

    private double highest() {
        return maxFrequency.orElse(band.maxFrequency());
    }

    /** The power of the other transmitters in a receiver with the given bandwidth, Hz, while they transmit, dBm. */
    double power(double bandwidth) {
        return density + 10.0 * Math.log10(bandwidth / MEGAHERTZ);
    }
}
