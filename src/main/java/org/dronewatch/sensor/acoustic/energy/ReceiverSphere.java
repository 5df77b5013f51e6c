package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.geometry.IntersectionHandler;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.OctaveBands;

/**
 * A sphere in which passing rays are counted: each contributes its energy times the length of its chord, and the sum
 * divided by the sphere's volume is the mean intensity in it. One per thread.
 */
final class ReceiverSphere {
    private static final int BANDS = OctaveBands.COUNT;

    /** Number of directions sampled to estimate the unobstructed volume of the sphere; accurate to about 1 %. */
    private static final int LOOKS = 100;

    private static final double GOLDEN_ANGLE = Math.PI * (3.0 - Math.sqrt(5.0));

    private final double radius;
    private final Air air;
    private double volume;
    private final EnergyTally tally;
    private final double[] brought = new double[BANDS];

    ReceiverSphere(double radius, Air air, EnergyTally tally) {
        this.radius = radius;
        this.air = air;
        this.tally = tally;
    }

    /**
     * Centres the sphere at a point. What a surface cuts off contributes nothing, and does not count in the volume
     * either: a drone just above a floor has half a sphere.
     *
     * @return its volume, m3
     */
    double surround(Position centre, RayTracer traversal) {
        double fraction = 0.0;
        for (int i = 0; i < LOOKS; i++) {
            // Spread evenly over the sphere (Fibonacci lattice).
            double z = 1.0 - (2.0 * i + 1.0) / LOOKS;
            double level = Math.sqrt(1.0 - z * z);
            double x = level * Math.cos(GOLDEN_ANGLE * i);
            double y = level * Math.sin(GOLDEN_ANGLE * i);
            boolean cut = traversal.closestHit(centre.x(), centre.y(), centre.z(), x, y, z, 0.0, radius);
            double free = cut ? traversal.distance() / radius : 1.0;
            fraction += free * free * free / LOOKS;
        }
        volume = fraction * 4.0 / 3.0 * Math.PI * radius * radius * radius;
        return volume;
    }

    /**
     * Counts the contribution of a ray to the sphere about a source, up to {@code end} metres from the ray's origin, if
     * it crosses the sphere.
     */
    void count(AcousticRay ray, double[] energy, double end, SoundSource source) {
        Position centre = source.position();
        double entry = IntersectionHandler.raySphere(
                ray.originX,
                ray.originY,
                ray.originZ,
                ray.directionX,
                ray.directionY,
                ray.directionZ,
                centre.x(),
                centre.y(),
                centre.z(),
                radius);
        if (entry >= end || !(volume > 0.0)) {
            return;
        }
        double x = centre.x() - ray.originX;
        double y = centre.y() - ray.originY;
        double z = centre.z() - ray.originZ;
        double middle = x * ray.directionX + y * ray.directionY + z * ray.directionZ;
        double besideSquared = Math.max(0.0, x * x + y * y + z * z - middle * middle);
        double exit = Math.min(end, middle + Math.sqrt(Math.max(0.0, radius * radius - besideSquared)));
        double at = 0.5 * (entry + exit);
        double chord = (exit - entry) / volume;
        for (int band = 0; band < BANDS; band++) {
            brought[band] = energy[band] * source.factor(band, ray.directionZ) * air.left(band, at) * chord;
        }
        tally.add(ray, brought, at);
    }
}
