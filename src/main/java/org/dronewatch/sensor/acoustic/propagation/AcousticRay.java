package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.IntersectionHandler;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;

/**
 * One straight segment of a sound ray. It carries two quantities: a level, which is used for detection and copied to
 * each outgoing ray, and an energy, which is divided among outgoing rays. A mutable, reused object, for use by one
 * thread.
 */
public final class AcousticRay {
    /** The medium of rays in air. */
    public static final int AIR = -1;

    /**
     * How far rays begin from the surface that they leave, as a fraction of the origin's coordinates: above the
     * rounding error of a mesh's coordinates, which have single precision; otherwise rays pass through oblique walls.
     * Faces are taken to coincide at greater distances than this.
     */
    private static final double STAND_OFF = 1e-7;

    /** The x coordinate of the origin, m. */
    public double originX;

    /** The y coordinate of the origin, m. */
    public double originY;

    /** The z coordinate of the origin, m. */
    public double originZ;

    /** The x component of the unit direction. */
    public double directionX;

    /** The y component of the unit direction. */
    public double directionY;

    /** The z component of the unit direction. */
    public double directionZ;

    /** Level at the origin, dB on the calibrated scale of the level model; not divided among outgoing rays. */
    public double level;

    /** Fraction of the drone's emitted energy that the ray carries at the origin. */
    public double energy;

    /** Path length from the drone to the origin, m. */
    public double travelled;

    /** Number of surfaces that the ray has hit. */
    public int order;

    /** Index of the material in which the ray propagates, or {@link #AIR}. */
    public int medium;

    /** Takes over the state of another ray. */
    public void copy(AcousticRay other) {
        originX = other.originX;
        originY = other.originY;
        originZ = other.originZ;
        directionX = other.directionX;
        directionY = other.directionY;
        directionZ = other.directionZ;
        level = other.level;
        energy = other.energy;
        travelled = other.travelled;
        order = other.order;
        medium = other.medium;
    }

    /** Whether the ray hits a surface; the tracer then has the triangle and the distance. */
    public boolean meets(RayTracer tracer) {
        return meets(tracer, Double.POSITIVE_INFINITY);
    }

    /** Whether the ray hits a surface within a given distance of its origin, m. */
    public boolean meets(RayTracer tracer, double limit) {
        return tracer.closestHit(originX, originY, originZ, directionX, directionY, directionZ, 0.0, limit);
    }

    /** Moves the ray's origin along its direction by a distance, m. */
    public void advance(double distance) {
        originX += distance * directionX;
        originY += distance * directionY;
        originZ += distance * directionZ;
    }

    /**
     * Moves the ray's origin off a surface, by more than the rounding error of the surface's coordinates.
     *
     * @param normal unit normal of the surface
     * @param side 1 for the side to which the normal points, -1 for the opposite side
     */
    public void standOff(double[] normal, double side) {
        double step = side * STAND_OFF * (1.0 + Math.abs(originX) + Math.abs(originY) + Math.abs(originZ));
        originX += step * normal[0];
        originY += step * normal[1];
        originZ += step * normal[2];
    }

    /** Reflects the ray specularly; its origin is unchanged. */
    public void reflect(double[] normal) {
        double twice = 2.0 * (directionX * normal[0] + directionY * normal[1] + directionZ * normal[2]);
        directionX -= twice * normal[0];
        directionY -= twice * normal[1];
        directionZ -= twice * normal[2];
    }

    /**
     * The distance from the ray's origin at which it enters a sphere, m; 0 if the origin is inside, infinite if the ray
     * misses the sphere.
     */
    public double entry(Position centre, double radius) {
        return IntersectionHandler.raySphere(
                originX,
                originY,
                originZ,
                directionX,
                directionY,
                directionZ,
                centre.x(),
                centre.y(),
                centre.z(),
                radius);
    }
}
