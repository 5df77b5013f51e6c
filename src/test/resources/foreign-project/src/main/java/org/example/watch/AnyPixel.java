package org.example.watch;

import org.dronewatch.sensor.camera.DetectionFunction;
import org.dronewatch.sensor.camera.DroneView;
import org.dronewatch.setting.Defaults;

/** Detects a drone that one pixel shows. */
public record AnyPixel() implements DetectionFunction {
    @Defaults
    public static final AnyPixel DEFAULT = new AnyPixel();

    @Override
    public double value(DroneView view) {
        return view.pixels();
    }

    @Override
    public double threshold() {
        return 1.0;
    }

    @Override
    public String unit() {
        return "px";
    }
}
