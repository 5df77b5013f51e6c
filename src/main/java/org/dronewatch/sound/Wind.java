package org.dronewatch.sound;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * The wind over a site: its mean speed grows logarithmically with the height z above the ground, as
 * {@code ln(1 + z / z0)}, as in a neutral surface layer.
 *
 * @param speed wind speed at a height of 10 m above the ground, 0 to 60 m/s
 * @param from direction from which it blows, clockwise from north, -4 pi to 4 pi, rad
 * @param roughness the roughness length z0 of the surroundings, 0.0001 to 2 m: 0.0002 for water, 0.03 for grass, 0.25
 *     for bushes, 1 for suburbs
 */
public record Wind(
        @In(value = Quantity.SPEED, from = 0, to = 60) double speed,
        @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double from,
        @In(value = Quantity.LENGTH, from = 1e-4, to = 2) double roughness) {
    /** No wind. */
    @Defaults
    public static final Wind CALM = new Wind(0.0, 0.0, 0.03);

    /** Height at which the speed is stated, m. */
    private static final double STATION = 10.0;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public Wind {
        Limits.check(Wind.class, speed, from, roughness);
    }

    /** This wind with another speed at 10 m, m/s. */
    public Wind withSpeed(double metresPerSecond) {
        return SettingsForm.with(this, "speed", metresPerSecond);
    }

    /** This wind from another direction, clockwise from north, rad. */
    public Wind withFrom(double bearing) {
        return SettingsForm.with(this, "from", bearing);
    }

    /** This wind with another roughness length, m. */
    public Wind withRoughness(double metres) {
        return SettingsForm.with(this, "roughness", metres);
    }

    /**
     * The speed of the wind at a height above the ground, m/s; 0 at the ground and below.
     *
     * @param height height above the ground, m
     */
    public double speedAt(double height) {
        return speed * logarithm(height) / logarithm(STATION);
    }

    /**
     * The mean increase of the wind speed with height, between two heights: the gradient of the linear profile with the
     * same speeds at both heights, 1/s.
     *
     * @param height one height above the ground, m
     * @param other the other height above the ground, m
     */
    public double shear(double height, double other) {
        double low = Math.max(0.0, Math.min(height, other));
        double high = Math.max(0.0, Math.max(height, other));
        // For close heights, a difference quotient loses digits; the slope midway between them is as good.
        double slope = high - low < 1e-3 * (high + roughness)
                ? 1.0 / (0.5 * (low + high) + roughness)
                : Math.log1p((high - low) / (low + roughness)) / (high - low);
        return speed * slope / logarithm(STATION);
    }

    private double logarithm(double height) {
        return Math.log1p(Math.max(0.0, height) / roughness);
    }

    /** The eastward component of a wind of unit speed: negative for wind from the east. */
    public double eastward() {
        return -Math.sin(from);
    }

    /** The northward component of a wind of unit speed: negative for wind from the north. */
    public double northward() {
        return -Math.cos(from);
    }
}
