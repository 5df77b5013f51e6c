package org.dronewatch.sensor.camera;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * Detects a drone that fills enough pixels.
 *
 * @param pixels how many, above 0
 */
public record PixelThreshold(@In(value = Quantity.PIXELS, above = 0) double pixels) implements DetectionFunction {
    /** Calibrated in the thesis that this project began with: 12 pixels. */
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

    @Override
    public String unit() {
        return Quantity.PIXELS.unit();
    }
}
