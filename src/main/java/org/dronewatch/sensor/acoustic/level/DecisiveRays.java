package org.dronewatch.sensor.acoustic.level;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;

/**
 * The rays from surfaces that can decide whether a drone is detected: those that would be loud enough if they went
 * straight to the sensor from their origin, since no path is shorter. Of the rays that are too quiet, or have hit too
 * many surfaces, to be reflected once more, only those that are directed at the sensor can decide. Immutable.
 */
final class DecisiveRays {
    /** A tolerance above the rounding error of the levels along a path, dB. */
    static final double ROUNDING = 1e-6;

    /** A tolerance above the relative rounding error of the distance between a ray and the sensor. */
    private static final double RELATIVE_ROUNDING = 1e-9;

    private final LevelModel model;
    private final Position sensor;
    private final double radius;
    private final double detectionLevel;

    /** The least loss of a ray at any surface, dB. */
    private final double leastLoss;

    DecisiveRays(LevelModel model, Position sensor, double radius, double detectionLevel, SurfaceLevels surfaces) {
        this.model = model;
        this.sensor = sensor;
        this.radius = radius * (1.0 + RELATIVE_ROUNDING);
        this.detectionLevel = detectionLevel;
        this.leastLoss = surfaces.leastLoss();
    }

    /** Whether a ray from a surface, or one that descends from it, can be loud enough at the sensor. */
    boolean include(AcousticRay ray) {
        ScatteredRays.Wanted wanted = of(ray);
        return wanted == ScatteredRays.Wanted.ALL || wanted == ScatteredRays.Wanted.DIRECTED && isDirectedAtSensor(ray);
    }

    /**
     * Which of the rays that have the same origin, level and order as a given ray from a surface can be loud enough at
     * the sensor.
     */
    ScatteredRays.Wanted of(AcousticRay ray) {
        double x = sensor.x() - ray.originX;
        double y = sensor.y() - ray.originY;
        double z = sensor.z() - ray.originZ;
        double highest = ray.level - model.attenuation() * Math.sqrt(x * x + y * y + z * z) + ROUNDING;
        if (highest < detectionLevel) {
            return ScatteredRays.Wanted.NONE;
        }
        boolean canBeReflected = ray.order < model.maxOrder() && highest - leastLoss >= detectionLevel;
        return canBeReflected ? ScatteredRays.Wanted.ALL : ScatteredRays.Wanted.DIRECTED;
    }

    /** A radius within which all rays count as directed at the sensor, m. */
    double radius() {
        return radius;
    }

    private boolean isDirectedAtSensor(AcousticRay ray) {
        return ray.entry(sensor, radius) < Double.POSITIVE_INFINITY;
    }
}
