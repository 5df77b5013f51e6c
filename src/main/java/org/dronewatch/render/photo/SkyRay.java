package org.dronewatch.render.photo;

import java.util.Arrays;

/**
 * What reaches a point in the atmosphere along a straight line: sunlight scattered once by air and haze, and light scattered
 * more often. All is relative to the sun's irradiance outside the atmosphere. One per thread.
 */
final class SkyRay {
    /** How much haze scatters forward (Henyey and Greenstein 1941). */
    private static final double FORWARD = 0.76;

    private static final double EVENLY = 1.0 / (4.0 * Math.PI);

    private final int steps;
    private final int stepsToSun;
    private final AirDepth depth = new AirDepth();
    private final AirDepth toSun = new AirDepth();
    private final double[] once = new double[Daylight.CHANNELS];
    private final double[] evenly = new double[Daylight.CHANNELS];
    private final double[] often = new double[Daylight.CHANNELS];

    /**
     * A ray.
     *
     * @param steps along the line
     * @param stepsToSun from each of its points
     */
    SkyRay(int steps, int stepsToSun) {
        this.steps = steps;
        this.stepsToSun = stepsToSun;
    }

    /**
     * Adds up what comes along a line.
     *
     * @param height of the observer, km
     * @param up sine of the elevation in which he looks
     * @param azimuth cosine of the angle between his azimuth and the sun's
     * @param sun elevation of the sun where he is, rad
     * @param more light scattered more often; null for a factor of 1
     */
    void follow(double height, double up, double azimuth, double sun, MultipleScattering more) {
        Arrays.fill(once, 0.0);
        Arrays.fill(evenly, 0.0);
        Arrays.fill(often, 0.0);
        depth.clear();
        double level = Math.sqrt(Math.max(0.0, 1.0 - up * up));
        double cosine = level * azimuth * Math.cos(sun) + up * Math.sin(sun);
        double byAir = 3.0 / (16.0 * Math.PI) * (1.0 + cosine * cosine);
        double byHaze = (1.0 - FORWARD * FORWARD)
                / (4.0 * Math.PI * Math.pow(1.0 + FORWARD * FORWARD - 2.0 * FORWARD * cosine, 1.5));
        double end = AirDepth.end(height, up);
        double from = 0.0;
        for (int step = 0; step < steps; step++) {
            double to = AirDepth.place((step + 1.0) / steps, height, up, end);
            double middle = 0.5 * (from + to);
            double above = AirDepth.heightAt(height, up, middle);
            depth.add(above, 0.5 * (to - from));
            double radius = AirDepth.EARTH + above;
            double sine =
                    (middle * level * azimuth * Math.cos(sun) + (AirDepth.EARTH + height + middle * up) * Math.sin(sun))
                            / radius;
            boolean lit = toSun.toSun(above, sine, stepsToSun);
            double haze = AirDepth.scatteredByHaze(above);
            if (more != null) {
                more.find(above, Math.asin(Math.max(-1.0, Math.min(1.0, sine))));
            }
            for (int channel = 0; channel < Daylight.CHANNELS; channel++) {
                double air = AirDepth.scatteredByAir(above, channel);
                if (lit) {
                    double light = (to - from) * Math.exp(-depth.with(toSun, channel));
                    once[channel] += light * (air * byAir + haze * byHaze);
                    evenly[channel] += light * (air + haze) * EVENLY;
                }
                double left = (to - from) * Math.exp(-depth.depth(channel));
                often[channel] += left * (air + haze) * (more == null ? 1.0 : more.radiance(channel));
            }
            depth.add(above, 0.5 * (to - from));
            from = to;
        }
        double ground = (AirDepth.EARTH + height + end * up) * Math.sin(sun) + end * level * azimuth * Math.cos(sun);
        double sine = ground / AirDepth.EARTH;
        if (AirDepth.meetsEarth(height, up) && sine > 0.0 && toSun.toSun(0.0, sine, stepsToSun)) {
            for (int channel = 0; channel < Daylight.CHANNELS; channel++) {
                double lit = AmbientLight.ALBEDO / Math.PI * sine * Math.exp(-depth.with(toSun, channel));
                once[channel] += lit;
                evenly[channel] += lit;
            }
        }
    }

    /** Radiance of sunlight scattered once on the way, or reflected by the ground, per sr. */
    double once(int channel) {
        return once[channel];
    }

    /** The same, if it were scattered equally in all directions. */
    double evenly(int channel) {
        return evenly[channel];
    }

    /** Radiance of light scattered more often; without a table, that of light whose radiance is 1 everywhere. */
    double often(int channel) {
        return often[channel];
    }
}
