package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * Connects a point of a surface that scatters sound to the source, through the walls in between: next-event estimation.
 * What is connected here must not be counted in the sphere again. One per thread.
 */
final class DiffuseConnection {
    private static final int BANDS = OctaveBands.COUNT;

    private final BandSurfaces surfaces;
    private final Air air;
    private final WallTransmission walls;
    private final EnergyTally tally;
    private final double[] brought = new double[BANDS];

    DiffuseConnection(World world, BandSurfaces surfaces, Air air, EnergyTally tally) {
        this.surfaces = surfaces;
        this.air = air;
        this.walls = new WallTransmission(world, surfaces);
        this.tally = tally;
    }

    /**
     * Adds what a surface scatters to the source.
     *
     * @param ray at the point where it hits the surface
     * @param normal of the surface, on the ray's side
     * @param material of the surface
     * @param scattered the energy that leaves by Lambert's law, in each band
     * @return whether anything arrives
     */
    boolean add(AcousticRay ray, double[] normal, int material, double[] scattered, SoundSource source) {
        Position position = source.position();
        double x = position.x() - ray.originX;
        double y = position.y() - ray.originY;
        double z = position.z() - ray.originZ;
        double squared = x * x + y * y + z * z;
        double along = x * normal[0] + y * normal[1] + z * normal[2];
        if (!(along > 0.0)
                || !walls.trace(
                        ray.originX, ray.originY, ray.originZ, position.x(), position.y(), position.z(), ray.medium)) {
            return false;
        }
        double distance = Math.sqrt(squared);
        double geometry = weight(ray, normal, along / distance, distance) * along / (distance * Math.PI * squared);
        double rise = z / distance;
        for (int band = 0; band < BANDS; band++) {
            brought[band] = scattered[band]
                    * surfaces.scatteredTo(material, band, along / distance)
                    * geometry
                    * walls.passed(band)
                    * source.factor(band, rise)
                    * air.left(band, distance);
        }
        tally.add(ray, brought, distance);
        return true;
    }

    /** Paths over a single surface are found from the source, too: see {@link FirstScattering}. */
    private double weight(AcousticRay ray, double[] normal, double leaving, double distance) {
        if (ray.order > 1 || !walls.isFree()) {
            return 1.0;
        }
        double arriving = -(ray.directionX * normal[0] + ray.directionY * normal[1] + ray.directionZ * normal[2]);
        double own = FirstScattering.density(arriving, ray.travelled);
        return own / (own + FirstScattering.density(leaving, distance));
    }
}
