package org.dronewatch.sensor.camera;

import java.util.List;

/** A detection by 12 pixels that keeps every view it is shown, so that tests can examine what a camera sees. */
record ViewRecorder(List<DroneView> views) implements DetectionFunction {
    @Override
    public double value(DroneView view) {
        views.add(view);
        return view.pixels();
    }

    @Override
    public double threshold() {
        return 12;
    }

    @Override
    public String unit() {
        return "px";
    }
}
