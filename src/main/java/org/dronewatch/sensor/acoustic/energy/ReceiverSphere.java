package org.dronewatch.sensor.acoustic.energy;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.acoustic.imagesource.SpecularLeg;
import org.dronewatch.sensor.acoustic.imagesource.SpecularPath;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * A sphere around the source in which passing rays from the sensor are counted, or one around the sensor for rays from
 * the source: each contributes its energy times the length of its chord, and the sum divided by the sphere's volume is
 * the mean intensity in it. In the open, where few rays pass, the sphere is wider, so that no single ray contributes
 * much of the total, but it is never large compared with the ray's length. Only the part in line of sight of its centre
 * counts: the far side of a wall does not. For use by one thread.
 */
final class ReceiverSphere {
    private static final int BANDS = OctaveBands.COUNT;

    /** Number of directions sampled to estimate the unobstructed volume of the sphere; accurate to about 1 %. */
    private static final int LOOKS = 100;

    /** A ray that passes within this radius is taken to be as strong as one that reaches the centre, m. */
    private static final double NEAR = 1.0;

    /** The largest fraction of the known sound that a single ray should contribute when the fewest rays are traced. */
    private static final double APPRECIABLE = 0.002;

    /** The largest radius, as a fraction of the length of a ray since it was last scattered. */
    private static final double SLENDER = 0.5;

    /** No sphere is wider than this in order to catch more rays, m. */
    private static final double WIDEST = 25.0;

    /** In a room, the sphere is no wider than this multiple of the radius of a ball with the room's volume. */
    private static final double ROOM = 1.5;

    private final double radius;
    private final Air air;
    private final EnergyTally tally;
    private final RayTracer tracer;
    private final Visibility visibility;
    private final WallPlanes planes;
    private final SpecularPath path;
    private final AcousticRay look = new AcousticRay();
    private final double[] free = new double[LOOKS];
    private final double[] brought = new double[BANDS];
    private Position centre;
    private double centreX;
    private double centreY;
    private double centreZ;
    private double widest;
    private double wanted;

    /** The volume within the radius that applies to rays from nearby, m3. */
    private double smallestVolume;

    /** The square of the radius that applies to the longest rays, which is the largest radius, m2. */
    private double farthestSquared;

    private double length;
    private double at;
    private double fraction;
    private double rise;
    private double riseFromBeginning;

    /**
     * A sphere.
     *
     * @param radius radius that applies to rays from nearby, m
     */
    ReceiverSphere(double radius, World world, WallPlanes planes, BandSurfaces surfaces, Air air, EnergyTally tally) {
        this.radius = radius;
        this.air = air;
        this.tally = tally;
        this.tracer = world.newIncoherentRayTracer();
        this.visibility = Visibility.ofClearPoints(world);
        this.planes = planes;
        this.path = new SpecularPath(world, planes, surfaces);
    }

    /**
     * Centres the sphere at a point.
     *
     * @param known estimate of the sound heard without the passing rays, in all bands, as intensity divided by the
     *     source's power, 1/m2; infinite if the sphere is not to be widened, since enough rays pass
     */
    void surround(Position point, double known) {
        centre = point;
        centreX = point.x();
        centreY = point.y();
        centreZ = point.z();
        // A ray contributes at most its energy divided by the cross-section of the sphere.
        wanted = Math.sqrt(BANDS / (Math.PI * EnergyTracer.FEWEST * APPRECIABLE * known));
        double farthest = Math.max(radius, WIDEST);
        for (int i = 0; i < LOOKS; i++) {
            Directions.ofLattice(i, LOOKS, look);
            boolean cut = tracer.closestHit(
                    centre.x(),
                    centre.y(),
                    centre.z(),
                    look.directionX,
                    look.directionY,
                    look.directionZ,
                    0.0,
                    farthest);
            free[i] = cut ? tracer.distance() : Double.POSITIVE_INFINITY;
        }
        smallestVolume = volume(radius);
        widest = Math.min(WIDEST, ROOM * Math.cbrt(volume(WIDEST) / ball(1.0)));
        double farthestReach = reach(Double.POSITIVE_INFINITY);
        farthestSquared = farthestReach * farthestReach;
    }

    /**
     * The volume in line of sight of the centre within a radius. A part that a surface cuts off contributes nothing,
     * and is not part of the volume either: a drone just above a floor has half a sphere.
     *
     * @param within the radius, at most the widest one, m
     * @return the volume, m3
     */
    double volume(double within) {
        double cubes = 0.0;
        for (double distance : free) {
            double seen = Math.min(distance, within);
            cubes += seen * seen * seen;
        }
        return ball(1.0) * cubes / LOOKS;
    }

    /** Whether the line of a ray passes near enough to the centre, whatever the ray's length. */
    boolean mayBeCrossed(AcousticRay ray) {
        return besideSquared(ray, middle(ray)) < farthestSquared;
    }

    /** The distance along a ray at which its line is nearest to the centre, m. */
    private double middle(AcousticRay ray) {
        return (centreX - ray.originX) * ray.directionX
                + (centreY - ray.originY) * ray.directionY
                + (centreZ - ray.originZ) * ray.directionZ;
    }

    /** The square of the distance from the centre to that point, m2; rounding may make it negative. */
    private double besideSquared(AcousticRay ray, double middle) {
        double x = centreX - ray.originX;
        double y = centreY - ray.originY;
        double z = centreZ - ray.originZ;
        return x * x + y * y + z * z - middle * middle;
    }

    /**
     * Whether a ray crosses the sphere by way of walls whose reflections lead to its centre.
     *
     * @param leg the ray's specular reflections since it began or was last scattered
     * @param end distance that the ray travels from its origin, m
     */
    boolean isCrossed(AcousticRay ray, SpecularLeg leg, double end, RandomGenerator random) {
        double middle = middle(ray);
        double difference = besideSquared(ray, middle);
        if (difference >= farthestSquared) {
            return false;
        }
        double besideSquared = Math.max(0.0, difference);
        // The path to the centre itself is tested, so that the sphere is the same for all rays reflected by these
        // walls.
        double along = leg.length() + middle;
        length = Math.sqrt(along * along + besideSquared);
        double reach = reach(length);
        if (besideSquared >= reach * reach) {
            return false;
        }
        double half = Math.sqrt(reach * reach - besideSquared);
        double entry = Math.max(0.0, middle - half);
        double exit = Math.min(end, middle + half);
        if (!(exit > entry)) {
            return false;
        }
        at = entry + random.nextDouble() * (exit - entry);
        fraction = (exit - entry) / (reach == radius ? smallestVolume : volume(reach));
        rise = -ray.directionZ;
        riseFromBeginning = leg.riseFromBeginning();
        if (!isSeen(ray, at)) {
            return false;
        }
        if (reach <= Math.max(radius, NEAR) || leg.isThroughWalls()) {
            return true;
        }
        // A ray that passes far from the centre need not reach it, and the path to the centre has another length.
        if (!leg.leadsTo(centre, path, planes)) {
            return false;
        }
        double nearer = (leg.length() + at) / path.length();
        fraction *= nearer * nearer;
        rise = path.riseFromEnd();
        riseFromBeginning = path.riseFromBeginning();
        return true;
    }

    private static double ball(double radius) {
        return 4.0 / 3.0 * Math.PI * radius * radius * radius;
    }

    /** Sine of the elevation at which a ray would leave the centre along the same path in reverse. */
    double rise() {
        return rise;
    }

    /** Sine of the elevation at which the path of that ray leaves the beginning of its leg. */
    double riseFromBeginning() {
        return riseFromBeginning;
    }

    /**
     * Counts a ray that crosses the sphere.
     *
     * @param energy energy in each band, at the ray's origin
     * @param others the sum of the inverse densities of legs at which the same path could be connected
     */
    void count(AcousticRay ray, double[] energy, double others) {
        double counted = fraction * (wanted > 0.0 ? Connections.weight(inverseDensity(length), others) : 1.0);
        for (int band = 0; band < BANDS; band++) {
            brought[band] = energy[band] * air.left(band, at) * counted;
        }
        tally.add(ray, brought, at);
    }

    private double reach(double length) {
        return Math.max(radius, Math.min(wanted, Math.min(widest, SLENDER * length)));
    }

    /**
     * The inverse density of a leg that is found because it passes the centre (see {@link Connections}): as with a
     * connected leg, a ray contributes its energy divided by this.
     *
     * @param length length of the leg, m
     */
    double inverseDensity(double length) {
        return Math.PI * reach(length) * reach(length);
    }

    /** The inverse density of a leg that is found because rays merge at its end, m2. */
    double inverseDensityOfMerging() {
        return MergedRays.inverseDensity(radius);
    }

    /** Whether nothing obstructs the line between the centre and a point of a ray. */
    private boolean isSeen(AcousticRay ray, double at) {
        return visibility.isFree(
                centre.x(),
                centre.y(),
                centre.z(),
                ray.originX + at * ray.directionX,
                ray.originY + at * ray.directionY,
                ray.originZ + at * ray.directionZ);
    }
}
