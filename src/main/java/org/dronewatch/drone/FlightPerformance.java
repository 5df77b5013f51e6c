package org.dronewatch.drone;

import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * The known limits of a drone's flight; limits that are not stated are {@linkplain FlightLimits#typical typical} of its
 * type of airframe. A flight that exceeds a limit causes a warning, but is flown as described; missions from files
 * climb and descend at these rates unless they state others.
 *
 * @param climb maximum rate of climb under power, 0.01 to 200 m/s; typically 3 m/s for multirotors, 5 m/s for
 *     fixed-wing drones and hybrids
 * @param sink maximum rate of descent under power, 0.01 to 200 m/s; typically 1.5 m/s for multirotors, 5 m/s for
 *     fixed-wing drones and hybrids
 * @param turnRate maximum rate of turn, above 0 and at most 20 pi rad/s (3600 degrees per second); typically that at
 *     cruise speed with a bank angle of 45 degrees (multirotors) or 50 degrees (others), {@code g tan(bank) / speed},
 *     where g is the acceleration of gravity
 * @param hover whether it can stay in one place; typically all but fixed-wing drones can
 * @param leastSpeed minimum speed under power of a drone that cannot hover, above 0 and at most 400 m/s; typically two
 *     thirds of the cruise speed. It is used only in the search for routes, and there replaced by the cruise speed if
 *     that is lower
 * @param ceiling maximum height above the surface below it, above 0 and at most 20,000 m; typically 500 m
 * @param endurance longest flight under power, above 0 and at most 604,800 s; typically 30 minutes for multirotors, an
 *     hour for fixed-wing drones and hybrids
 * @param glideRatio horizontal distance covered with the motors off per metre of height lost, 0 to 100; 0 for a drone
 *     that cannot glide, such as a multirotor; typically 10 for others
 * @param glideSpeed speed along the path while it glides, above 0 and at most 400 m/s; typically the cruise speed
 */
public record FlightPerformance(
        @In(value = Quantity.SPEED, from = 0.01, to = 200) Optional<Double> climb,
        @In(value = Quantity.SPEED, from = 0.01, to = 200) Optional<Double> sink,
        @In(value = Quantity.ANGULAR_SPEED, above = 0, to = 62.831853071795864) Optional<Double> turnRate,
        Optional<Boolean> hover,
        @In(value = Quantity.SPEED, above = 0, to = 400) Optional<Double> leastSpeed,
        @In(value = Quantity.LENGTH, above = 0, to = 20_000) Optional<Double> ceiling,
        @In(value = Quantity.DURATION, above = 0, to = LONGEST) Optional<Double> endurance,
        @In(value = Quantity.NUMBER, from = 0, to = 100) Optional<Double> glideRatio,
        @In(value = Quantity.SPEED, above = 0, to = 400) Optional<Double> glideSpeed) {
    /** The longest possible endurance, a week, s. */
    public static final double LONGEST = 604_800.0;

    /** A performance with all limits typical of the airframe. */
    @Defaults
    public static final FlightPerformance TYPICAL = new FlightPerformance(
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty());

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public FlightPerformance {
        Limits.check(
                FlightPerformance.class,
                climb,
                sink,
                turnRate,
                hover,
                leastSpeed,
                ceiling,
                endurance,
                glideRatio,
                glideSpeed);
    }

    /** This performance with another maximum rate of climb, m/s. */
    public FlightPerformance withClimb(double metresPerSecond) {
        return SettingsForm.with(this, "climb", Optional.of(metresPerSecond));
    }

    /** This performance with another maximum rate of descent, m/s. */
    public FlightPerformance withSink(double metresPerSecond) {
        return SettingsForm.with(this, "sink", Optional.of(metresPerSecond));
    }

    /** This performance with another maximum rate of turn, rad/s. */
    public FlightPerformance withTurnRate(double radiansPerSecond) {
        return SettingsForm.with(this, "turnRate", Optional.of(radiansPerSecond));
    }

    /** This performance with or without the ability to hover. */
    public FlightPerformance withHover(boolean able) {
        return SettingsForm.with(this, "hover", Optional.of(able));
    }

    /** This performance with another minimum speed under power of a drone that cannot hover, m/s. */
    public FlightPerformance withLeastSpeed(double metresPerSecond) {
        return SettingsForm.with(this, "leastSpeed", Optional.of(metresPerSecond));
    }

    /** This performance with another ceiling, m above the surface below. */
    public FlightPerformance withCeiling(double metres) {
        return SettingsForm.with(this, "ceiling", Optional.of(metres));
    }

    /** This performance with another endurance under power, s. */
    public FlightPerformance withEndurance(double seconds) {
        return SettingsForm.with(this, "endurance", Optional.of(seconds));
    }

    /** This performance with another glide ratio and glide speed, m/s. */
    public FlightPerformance withGlide(double ratio, double metresPerSecond) {
        return SettingsForm.with(this, "glideRatio", Optional.of(ratio)).withGlideSpeed(metresPerSecond);
    }

    private FlightPerformance withGlideSpeed(double metresPerSecond) {
        return SettingsForm.with(this, "glideSpeed", Optional.of(metresPerSecond));
    }

    /** The stated limits, and typical ones where none is stated. */
    FlightLimits orTypical(FlightLimits typical) {
        return new FlightLimits(
                climb.orElse(typical.climb()),
                sink.orElse(typical.sink()),
                turnRate.orElse(typical.turnRate()),
                hover.orElse(typical.hover()),
                leastSpeed.orElse(typical.leastSpeed()),
                ceiling.orElse(typical.ceiling()),
                endurance.orElse(typical.endurance()),
                glideRatio.orElse(typical.glideRatio()),
                glideSpeed.orElse(typical.glideSpeed()));
    }
}
