package org.dronewatch.sensor.acoustic.energy;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Paths from the source over one surface that scatters to the sensor, found from the source. Rays from the sensor find
 * the same paths; each kind alone almost never meets what is near the far end, where a drone flies low or a microphone
 * stands on the ground, and its standard error would not show it. Together, each path is weighted by the fraction of
 * the probability with which its own kind finds it (Veach and Guibas, SIGGRAPH 1995, the balance heuristic), and no
 * path is rare. One per thread.
 */
final class FirstScattering {
    private static final int BANDS = OctaveBands.COUNT;

    private final TriangleMesh mesh;
    private final RayTracer traversal;
    private final Visibility visibility;
    private final BandSurfaces surfaces;
    private final Air air;
    private final EnergyTally tally;
    private final AcousticRay ray = new AcousticRay();
    private final double[] normal = new double[3];
    private final double[] brought = new double[BANDS];

    FirstScattering(World world, BandSurfaces surfaces, Air air, EnergyTally tally) {
        this.mesh = world.mesh();
        this.traversal = world.newIncoherentRayTracer();
        this.visibility = Visibility.ofUnrelatedSegments(world);
        this.surfaces = surfaces;
        this.air = air;
        this.tally = tally;
    }

    /**
     * The chance with which uniform rays from a point find a point on a surface, over the surface's area and but for a
     * constant.
     *
     * @param cosine of the angle between the ray and the surface's normal
     * @param distance from the point, m
     */
    static double density(double cosine, double distance) {
        return cosine / (distance * distance);
    }

    /**
     * Follows one ray from the source to the first surface and on to the sensor.
     *
     * @return the number of segments traced
     */
    int add(SoundSource source, Position sensor, RandomGenerator random) {
        Position position = source.position();
        ray.originX = position.x();
        ray.originY = position.y();
        ray.originZ = position.z();
        Directions.draw(random, ray);
        if (!traversal.closestHit(
                ray.originX,
                ray.originY,
                ray.originZ,
                ray.directionX,
                ray.directionY,
                ray.directionZ,
                0.0,
                Double.POSITIVE_INFINITY)) {
            return 1;
        }
        double before = traversal.distance();
        int triangle = traversal.triangle();
        Normals.facing(mesh, triangle, ray, normal);
        double arriving = -(ray.directionX * normal[0] + ray.directionY * normal[1] + ray.directionZ * normal[2]);
        double atX = ray.originX + before * ray.directionX;
        double atY = ray.originY + before * ray.directionY;
        double atZ = ray.originZ + before * ray.directionZ;
        double x = sensor.x() - atX;
        double y = sensor.y() - atY;
        double z = sensor.z() - atZ;
        double after = Math.sqrt(x * x + y * y + z * z);
        double leaving = (x * normal[0] + y * normal[1] + z * normal[2]) / after;
        if (!(leaving > 0.0)) {
            return 1;
        }
        // From the sensor, so that the surface is at the far end for both kinds of rays.
        if (visibility.isFree(sensor.x(), sensor.y(), sensor.z(), atX, atY, atZ)) {
            double own = density(arriving, before);
            double weight = own / (own + density(leaving, after));
            double geometry = weight * leaving / (Math.PI * after * after);
            bring(source, mesh.material(triangle), arriving, leaving, before, after, geometry);
        }
        return 2;
    }

    private void bring(
            SoundSource source,
            int material,
            double arriving,
            double leaving,
            double before,
            double after,
            double geometry) {
        for (int band = 0; band < BANDS; band++) {
            brought[band] = source.fraction(band)
                    * source.factor(band, ray.directionZ)
                    * surfaces.reflected(material, band, arriving)
                    * surfaces.scattered(material, band)
                    * surfaces.scatteredTo(material, band, leaving)
                    * air.left(band, before + after)
                    * geometry;
        }
        ray.travelled = before;
        tally.add(ray, brought, after);
    }
}
