package org.dronewatch.sensor.camera;

/**
 * A function that needs a steady picture: without a pixel nothing is known of the crossing, and all seems well, less
 * the farther it looks. It never decreases with the number of pixels where there are any.
 */
record Steady(double threshold) implements DetectionFunction {
    @Override
    public double value(DroneView view) {
        return Math.max(0.0, 100.0 + view.pixels() - view.crossing() - 0.1 * view.range());
    }

    @Override
    public boolean growsWithPixels() {
        return true;
    }

    @Override
    public String unit() {
        return "";
    }
}
