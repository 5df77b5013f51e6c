package org.dronewatch.sensor.camera;

import java.util.Map;
import java.util.OptionalDouble;
import org.dronewatch.sensor.Condition;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A detection function that detects a drone by the number of its pixels.
 *
 * @param pixels number of pixels required, above 0 and at most 1e9
 */
public record PixelThreshold(@In(value = Quantity.PIXELS, above = 0, to = 1e9) double pixels)
        implements DetectionFunction {
    /**
     * 12 pixels, as calibrated in the master's thesis on which this project is based: <cite>Critical Infrastructure
     * Protection Against Attacks Using Drones</cite>, Czech Technical University in Prague, 2018.
     */
    @Defaults
    public static final PixelThreshold DEFAULT = new PixelThreshold(12.0);

    /** Checks the limit. */
    public PixelThreshold {
        Limits.check(PixelThreshold.class, pixels);
    }

    @Override
    public double value(DroneView view) {
        return view.pixels();
    }

    @Override
    public double threshold() {
        return pixels;
    }

    /** {@inheritDoc} Empty here: a positioner counts pixels, too, with its own threshold. */
    @Override
    public OptionalDouble followingValue(DroneView view) {
        return OptionalDouble.empty();
    }

    /** {@inheritDoc} A count of pixels takes no account of weather and light. */
    @Override
    public Map<Condition, String> ignoredConditions() {
        String other = "'detection: {kind: target-task}' takes light and weather into account";
        return Map.of(
                Condition.VISIBILITY, other,
                Condition.ILLUMINANCE, other,
                Condition.SUN, other,
                Condition.TURBULENCE, other,
                Condition.GROUND_BRIGHTNESS, other,
                Condition.RAIN, other);
    }

    @Override
    public boolean countsPixelsOnly() {
        return true;
    }

    @Override
    public boolean growsWithPixels() {
        return true;
    }

    @Override
    public String unit() {
        return Quantity.PIXELS.unit();
    }
}
