package org.dronewatch.render.photo;

/**
 * A straight line through {@link ClearAir}, divided into steps that are short where the air is dense: around its lowest
 * point. For use by one thread.
 */
final class AirPath {
    private double radius;
    private double up;
    private double end;
    private double lowest;
    private int steps;
    private int step;
    private double from;
    private double length;
    private double distance;
    private double height;
    private double air;
    private double haze;
    private double ozone;

    /**
     * Starts at a height, km, towards the top of the air or the ground.
     *
     * @param sine sine of the line's elevation
     */
    void start(double fromHeight, double sine, int number) {
        radius = ClearAir.EARTH + fromHeight;
        up = sine;
        end = ClearAir.length(fromHeight, sine);
        lowest = Math.min(end, Math.max(0.0, -radius * sine));
        steps = number;
        step = 0;
        from = 0.0;
    }

    /** Advances by a step; false at the end. */
    boolean next() {
        if (step == steps) {
            return false;
        }
        step++;
        double to = place((double) step / steps);
        length = to - from;
        distance = 0.5 * (from + to);
        height = Math.max(0.0, Math.sqrt(radius * radius + distance * (distance + 2.0 * radius * up)) - ClearAir.EARTH);
        air = ClearAir.air(height);
        haze = ClearAir.haze(height);
        ozone = ClearAir.ozone(height);
        from = to;
        return true;
    }

    /** The position of a point on the line, given by a fraction from 0 to 1. */
    private double place(double share) {
        // A line that ends at the ground is lowest there.
        double border = lowest == end ? 1.0 : Math.min(0.5, lowest / end);
        if (share < border) {
            double back = 1.0 - share / border;
            return lowest * (1.0 - back * back * back);
        }
        if (border == 1.0) {
            return end;
        }
        double on = (share - border) / (1.0 - border);
        return lowest + (end - lowest) * on * on * on;
    }

    /** Length of the step, km. */
    double length() {
        return length;
    }

    /** Distance of the step's middle from the start, km. */
    double distance() {
        return distance;
    }

    /** Height of the step's middle, km. */
    double height() {
        return height;
    }

    double air() {
        return air;
    }

    double haze() {
        return haze;
    }

    double ozone() {
        return ozone;
    }

    /** Optical depth of the step. */
    double depth(int channel) {
        return length * ClearAir.depth(channel, air, haze, ozone);
    }

    /** The step's length, less what is lost of scattered light within the step itself, km. */
    double seen(int channel) {
        double depth = depth(channel);
        return depth < 1e-6 ? length : -Math.expm1(-depth) / depth * length;
    }
}
