package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.imagesource.EnteredSolids;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * Connects a point at which a ray from the start is scattered with the target, and with the points at which a ray from
 * the target was first scattered: straight, through the walls in between, and by the reflections of image sources.
 * Paths that are connected here must not be counted again in the sphere. For use by one thread.
 */
final class DiffuseConnection {
    private static final int BANDS = OctaveBands.COUNT;

    private final int maxOrder;
    private final BandSurfaces surfaces;
    private final Air air;
    private final ConnectingLeg leg;
    private final EnergyTally tally;
    private final MergedRays merged;
    private final double[] brought = new double[BANDS];
    private Ends ends;
    private double[] images = new double[3];
    private double[] imagesOfStart = new double[3];
    private int wallOfRay;
    private boolean isJoined;

    DiffuseConnection(
            EnergyModel model,
            double radius,
            World world,
            WallPlanes planes,
            BandSurfaces surfaces,
            Air air,
            EnergyTally tally) {
        this.maxOrder = model.maxOrder();
        this.surfaces = surfaces;
        this.air = air;
        this.leg = new ConnectingLeg(world, planes, surfaces);
        this.tally = tally;
        this.merged = new MergedRays(model, radius, world, surfaces, tally);
    }

    /** Prepares for one look. */
    void seek(Ends next, WallPlanes planes) {
        ends = next;
        images = imagesOf(next.target(), next.ofTarget(), planes, images);
        imagesOfStart = imagesOf(next.start(), next.ofStart(), planes, imagesOfStart);
    }

    private static double[] imagesOf(Position point, ImageSources imageSources, WallPlanes planes, double[] into) {
        double[] target = into.length < 3 * imageSources.count() ? new double[3 * imageSources.count()] : into;
        imageSources.positions(point.x(), point.y(), point.z(), planes, target);
        return target;
    }

    /**
     * Adds the sound that a surface scatters towards the target.
     *
     * @param ray the ray, at the point at which it hits the surface
     * @param wall the plane of the surface, or {@link WallPlanes#NONE}
     * @param normal normal of the surface, on the ray's side
     * @param material material of the surface
     * @param leaving the energy that leaves the surface by Lambert's law, in each band
     * @param arrival the path by which the ray reached that point
     * @param scattered the points at which a ray from the target was first scattered
     * @return how many connections were tried
     */
    int add(
            AcousticRay ray,
            int wall,
            double[] normal,
            int material,
            double[] leaving,
            Arrival arrival,
            ScatteredSound scattered) {
        wallOfRay = wall;
        isJoined = false;
        leg.bend(ends.curvature(), ends.isFromSource());
        for (int image = ImageSources.ORIGINAL; image < ends.ofTarget().count(); image++) {
            if (ray.order + ends.ofTarget().order(image) <= maxOrder) {
                addFromTarget(image, ray, normal, material, leaving, arrival);
            }
        }
        for (int i = 0; i < scattered.count(); i++) {
            ScatteredSound.Point point = scattered.point(i);
            for (int image = ImageSources.ORIGINAL; image < ends.ofTarget().count(); image++) {
                if (ray.order + point.order + ends.ofTarget().order(image) <= maxOrder) {
                    join(image, ray, normal, material, leaving, arrival, point);
                }
            }
        }
        return leg.takeTraced();
    }

    /** The rays from both ends that are joined because they hit a surface near the same point. */
    MergedRays merged() {
        return merged;
    }

    private void addFromTarget(
            int image, AcousticRay ray, double[] normal, int material, double[] leaving, Arrival arrival) {
        if (!find(images, image, ray, WallPlanes.NONE)) {
            return;
        }
        double cosine = leg.cosineAtBeginning(normal);
        if (!(cosine > 0.0) || !isOpen(ray, arrival.solids(), images[0], images[1], images[2])) {
            return;
        }
        double distance = leg.length();
        // Rays from the target end at walls.
        double weight = leg.isThroughWalls()
                ? 1.0
                : Connections.weight(
                        Connections.fromPoint(cosine, distance),
                        arrival.inverseDensity(0, ends.ofTarget().order(image)));
        double geometry = weight * cosine / (Math.PI * distance * distance);
        for (int band = 0; band < BANDS; band++) {
            brought[band] = leaving[band]
                    * surfaces.scatteredTo(material, band, cosine)
                    * geometry
                    * leg.passed(band)
                    * ends.targetFactor(band, leg.riseFromEnd())
                    * air.left(band, distance);
        }
        isJoined |= image == ImageSources.ORIGINAL;
        tally.add(ray, brought, distance);
    }

    /** Whether sound reaches the target straight from the point that was added last. */
    boolean isJoined() {
        return isJoined;
    }

    private boolean find(double[] imagesOfEnd, int image, AcousticRay ray, int wallOfEnd) {
        return leg.find(
                ends.ofTarget(), imagesOfEnd, image, ray.originX, ray.originY, ray.originZ, wallOfRay, wallOfEnd);
    }

    private boolean isOpen(AcousticRay ray, EnteredSolids solids, double toX, double toY, double toZ) {
        double curvature = ends.curvature(ray.originX - toX, ray.originY - toY, ray.originZ - toZ);
        return leg.isOpen(ray.originX, ray.originY, ray.originZ, toX, toY, toZ, solids, curvature);
    }

    private void join(
            int image,
            AcousticRay ray,
            double[] normal,
            int material,
            double[] leaving,
            Arrival arrival,
            ScatteredSound.Point point) {
        if (!find(point.images, image, ray, point.wall)) {
            return;
        }
        double here = leg.cosineAtBeginning(normal);
        double there = leg.cosineAtEnd(point.normal);
        if (!(here > 0.0 && there > 0.0) || !isOpen(ray, arrival.solids(), point.x, point.y, point.z)) {
            return;
        }
        double distance = leg.length();
        double inverseDensity = Connections.betweenSurfaces(here, there, distance);
        double weight = leg.isThroughWalls()
                ? Connections.weight(Connections.throughWalls(inverseDensity), point.inverseDensity)
                : Connections.weight(
                        inverseDensity,
                        point.inverseDensity
                                + arrival.inverseDensity(
                                        point.scatterings,
                                        point.order + ends.ofTarget().order(image)));
        double geometry = weight * 4.0 * here * there / (Math.PI * distance * distance);
        for (int band = 0; band < BANDS; band++) {
            brought[band] = leaving[band]
                    * surfaces.scatteredTo(material, band, here)
                    * point.energy[band]
                    * surfaces.scatteredTo(point.material, band, there)
                    * geometry
                    * leg.passed(band)
                    * air.left(band, distance);
        }
        tally.add(ray, brought, distance + point.distance);
    }

    /**
     * Adds the sound that reaches the start from the points at which a ray from the target was first scattered.
     *
     * @return how many connections were tried
     */
    int addFrom(ScatteredSound scattered, AcousticRay scratch) {
        ImageSources imageSources = ends.ofStart();
        leg.bend(ends.curvature(), !ends.isFromSource());
        for (int i = 0; i < scattered.count(); i++) {
            ScatteredSound.Point point = scattered.point(i);
            for (int image = ImageSources.ORIGINAL; image < imageSources.count(); image++) {
                if (image == ImageSources.ORIGINAL || point.order + imageSources.order(image) <= maxOrder) {
                    addToStart(image, point, scratch);
                }
            }
        }
        return leg.takeTraced();
    }

    private void addToStart(int image, ScatteredSound.Point point, AcousticRay scratch) {
        if (!leg.find(ends.ofStart(), imagesOfStart, image, point.x, point.y, point.z, point.wall, WallPlanes.NONE)) {
            return;
        }
        double cosine = leg.cosineAtBeginning(point.normal);
        Position start = ends.start();
        // The leg is traced from the start, as arriving rays are, so that the surface is at the far end of both.
        double curvature = ends.curvature(start.x() - point.x, start.y() - point.y, start.z() - point.z);
        if (!(cosine > 0.0)
                || !leg.isOpen(
                        start.x(), start.y(), start.z(), point.x, point.y, point.z, EnteredSolids.NONE, curvature)) {
            return;
        }
        double distance = leg.length();
        double inverseDensity = Connections.fromPoint(cosine, distance);
        double weight = Connections.weight(
                leg.isThroughWalls() ? Connections.throughWalls(inverseDensity) : inverseDensity, point.inverseDensity);
        double geometry = weight * cosine / (Math.PI * distance * distance);
        for (int band = 0; band < BANDS; band++) {
            brought[band] = ends.source().fraction(band)
                    * ends.startFactor(band, leg.riseFromEnd())
                    * point.energy[band]
                    * surfaces.scatteredTo(point.material, band, cosine)
                    * geometry
                    * leg.passed(band)
                    * air.left(band, distance);
        }
        scratch.travelled = point.distance;
        tally.add(scratch, brought, distance);
    }
}
