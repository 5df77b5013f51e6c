package org.dronewatch.sensor.camera;

import org.dronewatch.setting.Check;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Quantity;

/**
 * Detects a drone that fills enough pixels.
 *
 * @param pixels how many, above 0
 */
public record PixelThreshold(@In(Quantity.PIXELS) double pixels) implements DetectionFunction {
    /** Calibrated in the thesis that this project began with: 12 pixels. */
    public static final PixelThreshold DEFAULT = new PixelThreshold(12.0);

    /** Checks the limit. */
    public PixelThreshold {
        Check.positive("pixels", pixels, Quantity.PIXELS);
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
