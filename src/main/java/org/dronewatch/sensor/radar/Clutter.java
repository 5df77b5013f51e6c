package org.dronewatch.sensor.radar;

import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * Clutter, the echoes of ground and rain in a drone's resolution cell, which is as wide as the beam and as deep as the
 * range resolution {@code c / (2 B)}, where c is the speed of light and B the bandwidth. The residual clutter after the
 * radar's filters is added to the noise.
 *
 * @param ground backscatter of the site's surface
 * @param improvement improvement factor of the radar against ground clutter, 0 to 150 dB: increase in the
 *     signal-to-clutter ratio due to its filters, for a drone at a speed that they pass
 * @param rainImprovement improvement factor against rain, which moves, 0 to 150 dB
 * @param bandwidth bandwidth B of the transmitted signal, 1 to 1e12 Hz; omit it if the budget states it as
 *     sweepBandwidth
 */
public record Clutter(
        SurfaceReflectivity ground,
        @In(value = Quantity.LEVEL, from = 0, to = 150) double improvement,
        @Minor @In(value = Quantity.LEVEL, from = 0, to = 150) double rainImprovement,
        @Minor @In(value = Quantity.FREQUENCY, from = 1, to = 1e12) Optional<Double> bandwidth) {
    /** The setting that is required where the radar's budget states no bandwidth. */
    private static final String BANDWIDTH = "bandwidth";

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public Clutter {
        Limits.check(Clutter.class, ground, improvement, rainImprovement, bandwidth);
    }

    /** Clutter with an improvement factor of 20 dB (an assumption) against rain, and the bandwidth of the budget. */
    @Defaults({"ground", "improvement"})
    public static Clutter of(SurfaceReflectivity ground, double improvement) {
        return new Clutter(ground, improvement, 20.0, Optional.empty());
    }

    /** This clutter with another improvement factor against the ground, dB. */
    public Clutter withImprovement(double decibels) {
        return SettingsForm.with(this, "improvement", decibels);
    }

    /** This clutter with another improvement factor against rain, dB. */
    public Clutter withRainImprovement(double decibels) {
        return SettingsForm.with(this, "rainImprovement", decibels);
    }

    /** This clutter with another bandwidth, which determines the size of range cells, Hz. */
    public Clutter withBandwidth(double hertz) {
        return SettingsForm.with(this, BANDWIDTH, Optional.of(hertz));
    }

    /**
     * Checks that there is one bandwidth.
     *
     * @throws IllegalArgumentException when neither the budget nor this clutter states one, or both do
     */
    void checkBandwidth(LinkBudget budget) {
        boolean hasOwn = budget instanceof LinkBudget.Hardware;
        if (hasOwn && bandwidth.isPresent()) {
            throw new IllegalArgumentException(
                    "clutter.bandwidth and budget.sweepBandwidth are mutually exclusive: omit clutter.bandwidth");
        }
        if (!hasOwn && bandwidth.isEmpty()) {
            throw new IllegalArgumentException("clutter needs a bandwidth: the budget states none");
        }
    }

    /** Depth of a range cell with a budget, m. */
    double depth(LinkBudget budget) {
        double hertz =
                budget instanceof LinkBudget.Hardware hardware ? hardware.sweepBandwidth() : bandwidth.orElseThrow();
        return LinkBudget.LIGHT / (2.0 * hertz);
    }
}
