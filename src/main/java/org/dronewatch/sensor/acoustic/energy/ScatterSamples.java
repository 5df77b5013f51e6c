package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * The points at which a few rays from a given point are scattered: a rough picture of where the sound that is scattered
 * to this point comes from. For use by one thread.
 */
final class ScatterSamples {
    /** The same point has the same samples: they affect how sound is computed, not its expected value. */
    private static final long SEED = 20181126;

    private static final double FAINT = 1e-3;

    /** A ray that has left the site. */
    private static final double ESCAPED = -1.0;

    private final World world;
    private final WallPlanes planes;
    private final Normals normals;
    private final RayTracer tracer;
    private final double[] reflected;
    private final double[] scattered;
    private final AcousticRay ray = new AcousticRay();
    private final double[] normal = new double[3];

    ScatterSamples(World world, WallPlanes planes, BandSurfaces surfaces) {
        this.world = world;
        this.planes = planes;
        this.normals = new Normals(world.mesh());
        this.tracer = world.newIncoherentRayTracer();
        int materials = world.surfaces().size();
        this.reflected = new double[materials];
        this.scattered = new double[materials];
        for (int material = 0; material < materials; material++) {
            for (int band = 0; band < OctaveBands.COUNT; band++) {
                reflected[material] += surfaces.reflected(material, band) / OctaveBands.COUNT;
                scattered[material] += surfaces.scattered(material, band) / OctaveBands.COUNT;
            }
        }
    }

    /**
     * A point of a surface where sound was scattered.
     *
     * @param at position of the point, m
     * @param normal unit normal of the surface on the side of the sound
     * @param wall the plane of the surface, or {@link WallPlanes#NONE}
     * @param energy the fraction of a ray's energy that is scattered there, mean of all bands
     */
    record Sample(Position at, double[] normal, int wall, double energy) {}

    /**
     * All samples of a point.
     *
     * @param points points at which its rays were scattered
     * @param rays number of rays that left it
     * @param escaped the fraction of them that left the site
     * @param left the mean fraction of their energy that is left after the last surface, 0 for those that left the site
     * @param materials the materials of the surfaces that scattered them
     */
    record Samples(List<Sample> points, int rays, double escaped, double left, Set<Integer> materials) {}

    /**
     * Samples of a point.
     *
     * @param rays number of rays that leave it
     * @param most maximum number of surfaces that each of them hits
     */
    Samples from(Position point, int rays, int most) {
        SplittableRandom random = new SplittableRandom(SEED);
        List<Sample> samples = new ArrayList<>();
        Set<Integer> materials = new TreeSet<>();
        int escaped = 0;
        double all = 0.0;
        for (int i = 0; i < rays; i++) {
            Directions.ofLattice(i, rays, ray);
            ray.originX = point.x();
            ray.originY = point.y();
            ray.originZ = point.z();
            double left = follow(random, most, samples, materials);
            escaped += left < 0.0 ? 1 : 0;
            all += Math.max(0.0, left);
        }
        return new Samples(List.copyOf(samples), rays, (double) escaped / rays, all / rays, Set.copyOf(materials));
    }

    /** Follows the ray; returns the fraction of its energy that is left, or {@link #ESCAPED}. */
    private double follow(SplittableRandom random, int most, List<Sample> samples, Set<Integer> materials) {
        double left = 1.0;
        int times = 0;
        while (times < most && left > FAINT) {
            if (!ray.meets(tracer)) {
                return ESCAPED;
            }
            normals.facing(tracer.triangle(), ray, normal);
            ray.advance(tracer.distance());
            int material = world.material(tracer.triangle(), ray.originX, ray.originY);
            ray.standOff(normal, 1.0);
            left *= reflected[material];
            if (scattered[material] > 0.0) {
                materials.add(material);
                samples.add(new Sample(
                        new Position(ray.originX, ray.originY, ray.originZ),
                        normal.clone(),
                        planes.wallOf(tracer.triangle()),
                        left * scattered[material]));
            }
            if (random.nextDouble() < scattered[material]) {
                Directions.drawLambert(random, normal, ray);
            } else {
                ray.reflect(normal);
            }
            times++;
        }
        return left;
    }
}
