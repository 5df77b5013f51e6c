package org.dronewatch.sensor.acoustic.energy;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.imagesource.SpecularLeg;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * The points at which one ray from the target is scattered. Each of them is a target for rays from the start, which by
 * themselves almost never hit the surfaces near the target when a drone flies low or lies on the ground. For use by one
 * thread.
 */
final class ScatteredSound {
    private static final int BANDS = OctaveBands.COUNT;

    /** Maximum number of surfaces that a ray hits. */
    static final int MOST = 6;

    private final World world;
    private final Normals normals;
    private final RayTracer tracer;
    private final WallPlanes planes;
    private final BandSurfaces surfaces;
    private final ReceiverSphere ofTarget;
    private final ReceiverSphere ofStart;
    private final Air air;
    private final AcousticRay ray = new AcousticRay();
    private final SpecularLeg leg = new SpecularLeg();
    private final double[] energy = new double[BANDS];
    private final double[] normal = new double[3];
    private final Point[] points = new Point[MOST];
    private final double[] sent = new double[BANDS];
    private Ends ends;
    private int count;

    ScatteredSound(
            World world,
            WallPlanes planes,
            BandSurfaces surfaces,
            ReceiverSphere ofTarget,
            ReceiverSphere ofStart,
            Air air) {
        this.world = world;
        this.normals = new Normals(world.mesh());
        this.tracer = world.newIncoherentRayTracer();
        this.planes = planes;
        this.surfaces = surfaces;
        this.ofTarget = ofTarget;
        this.ofStart = ofStart;
        this.air = air;
        for (int i = 0; i < MOST; i++) {
            points[i] = new Point();
        }
    }

    /** A point of a surface that scatters sound from the target. */
    static final class Point {
        /** Unit normal of the surface, on the side of the ray. */
        final double[] normal = new double[3];

        /** The energy that it scatters, by band, W, as if all the power of a one-watt source had arrived here. */
        final double[] energy = new double[BANDS];

        /** The images of this point in the walls of the image sources of the target. */
        double[] images = new double[3];

        /**
         * Whether rays from the start may merge here: they may at the point at which the sound is first scattered, on a
         * connected path.
         */
        boolean isConnected;

        /** Number of the surface's material. */
        int material;

        /** The plane of the surface, or {@link WallPlanes#NONE}. */
        int wall;

        /** The x coordinate of the point, m. */
        double x;

        double y;
        double z;

        /** Length of the path from the target, m. */
        double distance;

        /** The number of surfaces that the sound has hit, including this one. */
        int order;

        /** The number of times that the sound has been scattered, including here. */
        int scatterings;

        /** The sum of the inverse densities of all legs from the target to here. */
        double inverseDensity;
    }

    /** Number of points. */
    int count() {
        return count;
    }

    /** A point of the last ray. */
    Point point(int number) {
        return points[number];
    }

    /**
     * Follows one ray from the target.
     *
     * @return the number of segments traced
     */
    int follow(Ends both, int maxOrder, RandomGenerator random) {
        ends = both;
        Position position = ends.target();
        ray.originX = position.x();
        ray.originY = position.y();
        ray.originZ = position.z();
        Directions.draw(random, ray);
        ray.travelled = 0.0;
        for (int band = 0; band < BANDS; band++) {
            energy[band] = ends.targetFactor(band, ray.directionZ);
        }
        count = 0;
        leg.begin(ray);
        int scatterings = 0;
        double leaving = 0.0;
        double before = 0.0;
        boolean isFirstConnected = false;
        for (int order = 1; order <= Math.min(MOST, maxOrder + 1); order++) {
            boolean hit = ray.meets(tracer);
            if (ends.isOpen() && scatterings > 0 && leg.order() > 0 && !leg.matchesFromEnd(ends.ofStart())) {
                countPassing(hit ? tracer.distance() : Double.POSITIVE_INFINITY, before, random);
            }
            if (!hit || order > maxOrder) {
                return order;
            }
            int triangle = tracer.triangle();
            double flown = tracer.distance();
            normals.facing(triangle, ray, normal);
            ray.advance(flown);
            int material = world.material(triangle, ray.originX, ray.originY);
            ray.standOff(normal, 1.0);
            ray.travelled += flown;
            leg.travel(flown);
            double arriving = -along();
            boolean isOfImage = leg.order() == 0 || leg.matchesFromStart(ends.ofTarget());
            double inverseDensity = before;
            if (isOfImage) {
                inverseDensity += scatterings == 0
                        ? Connections.fromPoint(arriving, leg.length())
                        : Connections.betweenSurfaces(leaving, arriving, leg.length());
            } else if (scatterings == 0 && ends.isOpen()) {
                // Rays from the start may pass the target.
                inverseDensity = ofTarget.inverseDensity(leg.length());
            } else if (scatterings == 0) {
                // Indoors, enough of them do.
                return order;
            } else if (isFirstConnected && scatterings == 1) {
                // Rays from the start may merge with this one at the point at which it was first scattered.
                inverseDensity += ofTarget.inverseDensityOfMerging();
            }
            if (surfaces.anyScatters()) {
                for (int band = 0; band < BANDS; band++) {
                    energy[band] *= air.left(band, flown) * surfaces.reflected(material, band, arriving);
                }
            }
            boolean isScattered = false;
            if (surfaces.scatters(material)) {
                add(triangle, material, order, scatterings + 1, inverseDensity);
                points[count - 1].isConnected = isOfImage && scatterings == 0;
                double chance = surfaces.chanceOfScattering(material, energy);
                isScattered = random.nextDouble() < chance;
                for (int band = 0; band < BANDS; band++) {
                    double fraction = surfaces.scattered(material, band);
                    energy[band] *= isScattered ? fraction / chance : (1.0 - fraction) / (1.0 - chance);
                }
            }
            if (isScattered) {
                isFirstConnected = isOfImage && scatterings == 0;
                scatterings++;
                if (scatterings == ends.scatterings()) {
                    return order;
                }
                Directions.drawLambert(random, normal, ray);
                leaving = along();
                for (int band = 0; band < BANDS; band++) {
                    energy[band] *= surfaces.scatteredTo(material, band, leaving);
                }
                before = inverseDensity;
                leg.begin(ray);
            } else if (surfaces.mirrors(material)) {
                ray.reflect(normal);
                leg.reflect(planes.wallOf(triangle));
            } else {
                return order;
            }
        }
        return Math.min(MOST, maxOrder);
    }

    /** Counts the ray in the sphere around the start. */
    private void countPassing(double end, double inverseDensity, RandomGenerator random) {
        if (!ofStart.isCrossed(ray, leg, end, random)) {
            return;
        }
        for (int band = 0; band < BANDS; band++) {
            sent[band] = energy[band] * ends.source().fraction(band) * ends.startFactor(band, ofStart.rise());
        }
        ofStart.count(ray, sent, inverseDensity);
    }

    /** The component of the ray's direction along the normal. */
    private double along() {
        return ray.directionX * normal[0] + ray.directionY * normal[1] + ray.directionZ * normal[2];
    }

    private void add(int triangle, int material, int order, int scatterings, double inverseDensity) {
        Point point = points[count++];
        System.arraycopy(normal, 0, point.normal, 0, normal.length);
        point.x = ray.originX;
        point.y = ray.originY;
        point.z = ray.originZ;
        point.distance = ray.travelled;
        point.order = order;
        point.scatterings = scatterings;
        point.inverseDensity = inverseDensity;
        point.material = material;
        point.wall = planes.wallOf(triangle);
        for (int band = 0; band < BANDS; band++) {
            point.energy[band] = energy[band] * surfaces.scattered(material, band);
        }
        ImageSources imageSources = ends.ofTarget();
        if (point.images.length < 3 * imageSources.count()) {
            point.images = new double[3 * imageSources.count()];
        }
        imageSources.positions(point.x, point.y, point.z, planes, point.images);
    }
}
