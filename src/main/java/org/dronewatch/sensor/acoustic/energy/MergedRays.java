package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Joins a ray from the start with one from the target if both hit a surface near the same point: the sound is scattered
 * there from one ray into the other (vertex merging: Georgiev, Krivanek, Davidovic and Slusallek, SIGGRAPH Asia 2012).
 * A surface very near the target, such as the wall on which a microphone is mounted, is so loud there that a single ray
 * that happens to hit that point would otherwise outweigh thousands. Rays are merged only if they come from a specular
 * reflection for which no image source is known: other rays are connected from either side. For use by one thread.
 */
final class MergedRays {
    private static final int BANDS = OctaveBands.COUNT;

    /** Rays meet if the points that they hit are within this fraction of the radius of the receiver. */
    private static final double NEAR = 0.5;

    /** Least cosine of the angle between the normals of two points that count as belonging to the same surface. */
    private static final double ALIKE = 0.99;

    /**
     * The greatest distance of one of two such points from the plane of the other, as a fraction of their distance from
     * each other.
     */
    private static final double OFF = 0.1;

    /** Number of directions along a surface in which walls that limit it are searched for. */
    private static final int LOOKS = 8;

    private final int maxOrder;
    private final double within;
    private final BandSurfaces surfaces;
    private final EnergyTally tally;
    private final Visibility visibility;
    private final double[] brought = new double[BANDS];
    private final double[] aside = new double[3];

    /**
     * Merges rays.
     *
     * @param radius radius of the receiver, m
     */
    MergedRays(EnergyModel model, double radius, World world, BandSurfaces surfaces, EnergyTally tally) {
        this.maxOrder = model.maxOrder();
        this.within = NEAR * radius;
        this.surfaces = surfaces;
        this.tally = tally;
        this.visibility = Visibility.ofClearPoints(world);
    }

    /**
     * The inverse density of a leg whose end is found because rays merge there (see {@link Connections}), m2.
     *
     * @param radius radius of the receiver, m
     */
    static double inverseDensity(double radius) {
        return Math.PI * NEAR * NEAR * radius * radius;
    }

    /**
     * Whether any of the points at which a ray from the target was scattered is near the point that a ray from the
     * start has hit.
     */
    boolean mayAdd(AcousticRay ray, ScatteredSound scattered) {
        for (int i = 0; i < scattered.count(); i++) {
            if (isWithin(ray, scattered.point(i))) {
                return true;
            }
        }
        return false;
    }

    private boolean isWithin(AcousticRay ray, ScatteredSound.Point point) {
        double x = ray.originX - point.x;
        double y = ray.originY - point.y;
        double z = ray.originZ - point.z;
        return x * x + y * y + z * z < within * within;
    }

    /**
     * Adds the sound that a surface scatters towards the target.
     *
     * @param ray the ray, at the point at which it hits the surface
     * @param normal normal of the surface, on the ray's side
     * @param material material of the surface
     * @param leaving the energy that leaves the surface by Lambert's law, in each band
     * @param arrival the path by which the ray reached that point
     * @param scattered the points at which a ray from the target was scattered
     */
    void add(
            AcousticRay ray,
            double[] normal,
            int material,
            double[] leaving,
            Arrival arrival,
            ScatteredSound scattered) {
        for (int i = 0; i < scattered.count(); i++) {
            ScatteredSound.Point point = scattered.point(i);
            if (point.isConnected && ray.order + point.order - 1 <= maxOrder && isNear(ray, normal, material, point)) {
                add(ray, material, leaving, arrival, point);
            }
        }
    }

    private boolean isNear(AcousticRay ray, double[] normal, int material, ScatteredSound.Point point) {
        double x = ray.originX - point.x;
        double y = ray.originY - point.y;
        double z = ray.originZ - point.z;
        double square = x * x + y * y + z * z;
        if (!isWithin(ray, point) || material != point.material) {
            return false;
        }
        double[] other = point.normal;
        double off = x * other[0] + y * other[1] + z * other[2];
        return normal[0] * other[0] + normal[1] * other[1] + normal[2] * other[2] > ALIKE
                && off * off <= OFF * OFF * square
                && visibility.isFree(ray.originX, ray.originY, ray.originZ, point.x, point.y, point.z);
    }

    private void add(AcousticRay ray, int material, double[] leaving, Arrival arrival, ScatteredSound.Point point) {
        double mine = Math.PI * within * within;
        double others = point.inverseDensity + arrival.inverseDensity(0, point.order - 1) - mine;
        double shared = 4.0 * Connections.weight(mine, others) / area(point);
        for (int band = 0; band < BANDS; band++) {
            // Both the point's energy and the energy that leaves here are already reduced by what the surface absorbs,
            // which must be deducted only once.
            double scattering = surfaces.reflected(material, band) * surfaces.scattered(material, band);
            brought[band] = scattering > 0.0 ? leaving[band] * point.energy[band] / scattering * shared : 0.0;
        }
        tally.add(ray, brought, point.distance);
    }

    /** The area around a point, as far as walls do not limit it, m2. */
    private double area(ScatteredSound.Point point) {
        double[] up = point.normal;
        boolean isUpright = Math.abs(up[2]) < 0.9;
        aside[0] = isUpright ? up[1] : 0.0;
        aside[1] = isUpright ? -up[0] : up[2];
        aside[2] = isUpright ? 0.0 : -up[1];
        double length = Math.sqrt(aside[0] * aside[0] + aside[1] * aside[1] + aside[2] * aside[2]);
        double squares = 0.0;
        for (int look = 0; look < LOOKS; look++) {
            double u = Math.cos(2.0 * Math.PI * look / LOOKS) / length;
            double v = Math.sin(2.0 * Math.PI * look / LOOKS) / length;
            double x = u * aside[0] + v * (up[1] * aside[2] - up[2] * aside[1]);
            double y = u * aside[1] + v * (up[2] * aside[0] - up[0] * aside[2]);
            double z = u * aside[2] + v * (up[0] * aside[1] - up[1] * aside[0]);
            boolean isCut = visibility.findFirstAlong(point.x, point.y, point.z, x, y, z, within);
            double free = isCut ? visibility.distance() : within;
            squares += free * free;
        }
        return Math.PI * squares / LOOKS;
    }
}
