package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * Connects a point where a ray from the sensor is scattered to the source, and to the points where a ray from the source
 * was scattered first: straight, through the walls in between, and over the chains of walls seen from the source. What
 * is connected here must not be counted in the sphere again. One per thread.
 */
final class DiffuseConnection {
    private static final int BANDS = OctaveBands.COUNT;

    private final int maxOrder;
    private final BandSurfaces surfaces;
    private final Air air;
    private final WallTransmission walls;
    private final MirrorPath path;
    private final EnergyTally tally;
    private final double[] brought = new double[BANDS];
    private Ends ends;
    private double[] images = new double[3];
    private double[] imagesOfSensor = new double[3];
    private int traced;

    DiffuseConnection(
            EnergyModel model, World world, WallPlanes planes, BandSurfaces surfaces, Air air, EnergyTally tally) {
        this.maxOrder = model.maxOrder();
        this.surfaces = surfaces;
        this.air = air;
        this.walls = new WallTransmission(world, surfaces);
        this.path = new MirrorPath(world, planes, surfaces);
        this.tally = tally;
    }

    /** Prepares for one look. */
    void seek(Ends next, WallPlanes planes) {
        ends = next;
        images = imagesOf(next.source().position(), next.ofSource(), planes, images);
        imagesOfSensor = imagesOf(next.sensor(), next.ofSensor(), planes, imagesOfSensor);
    }

    private static double[] imagesOf(Position point, MirrorChains chains, WallPlanes planes, double[] into) {
        double[] target = into.length < 3 * chains.count() ? new double[3 * chains.count()] : into;
        chains.images(point.x(), point.y(), point.z(), planes, target);
        return target;
    }

    /**
     * Adds what a surface scatters towards the source.
     *
     * @param ray at the point where it hits the surface
     * @param normal of the surface, on the ray's side
     * @param material of the surface
     * @param leaving the energy that leaves by Lambert's law, in each band
     * @param arrival how the ray came there
     * @param scattered where a ray from the source was scattered first
     * @return how many connections were tried
     */
    int add(
            AcousticRay ray,
            double[] normal,
            int material,
            double[] leaving,
            Arrival arrival,
            ScatteredSound scattered) {
        traced = 0;
        addStraight(ray, normal, material, leaving, arrival);
        for (int chain = 1; chain < ends.ofSource().count(); chain++) {
            if (ray.order + ends.ofSource().order(chain) <= maxOrder) {
                addOver(chain, ray, normal, material, leaving, arrival);
            }
        }
        for (int i = 0; i < scattered.count(); i++) {
            join(ray, normal, material, leaving, arrival, scattered.point(i));
        }
        return traced;
    }

    private void addStraight(AcousticRay ray, double[] normal, int material, double[] leaving, Arrival arrival) {
        SoundSource source = ends.source();
        Position position = source.position();
        double x = position.x() - ray.originX;
        double y = position.y() - ray.originY;
        double z = position.z() - ray.originZ;
        double distance = Math.sqrt(x * x + y * y + z * z);
        double cosine = (x * normal[0] + y * normal[1] + z * normal[2]) / distance;
        if (!(cosine > 0.0)) {
            return;
        }
        traced++;
        if (!walls.trace(ray.originX, ray.originY, ray.originZ, position.x(), position.y(), position.z(), ray.medium)) {
            return;
        }
        // Rays from the source end at walls.
        double weight = walls.isFree()
                ? Connections.weight(Connections.fromPoint(cosine, distance), arrival.reluctance(0, 0))
                : 1.0;
        double geometry = weight * cosine / (Math.PI * distance * distance);
        for (int band = 0; band < BANDS; band++) {
            brought[band] = leaving[band]
                    * surfaces.scatteredTo(material, band, cosine)
                    * geometry
                    * walls.passed(band)
                    * source.factor(band, z / distance)
                    * air.left(band, distance);
        }
        tally.add(ray, brought, distance);
    }

    private void addOver(int chain, AcousticRay ray, double[] normal, int material, double[] leaving, Arrival arrival) {
        SoundSource source = ends.source();
        if (!path.follow(ends.ofSource(), images, chain, ray.originX, ray.originY, ray.originZ)) {
            return;
        }
        traced += ends.ofSource().order(chain) + 1;
        double cosine = path.cosineAtBeginning(normal);
        if (!(cosine > 0.0)) {
            return;
        }
        double distance = path.length();
        double weight = Connections.weight(
                Connections.fromPoint(cosine, distance),
                arrival.reluctance(0, ends.ofSource().order(chain)));
        double geometry = weight * cosine / (Math.PI * distance * distance);
        for (int band = 0; band < BANDS; band++) {
            brought[band] = leaving[band]
                    * surfaces.scatteredTo(material, band, cosine)
                    * geometry
                    * path.reflected(band)
                    * source.factor(band, path.riseFromEnd())
                    * air.left(band, distance);
        }
        tally.add(ray, brought, distance);
    }

    private void join(
            AcousticRay ray,
            double[] normal,
            int material,
            double[] leaving,
            Arrival arrival,
            ScatteredSound.Point point) {
        if (ray.order + point.order > maxOrder) {
            return;
        }
        double x = point.x - ray.originX;
        double y = point.y - ray.originY;
        double z = point.z - ray.originZ;
        double distance = Math.sqrt(x * x + y * y + z * z);
        double here = (x * normal[0] + y * normal[1] + z * normal[2]) / distance;
        double there = -(x * point.normal[0] + y * point.normal[1] + z * point.normal[2]) / distance;
        if (here > 0.0 && there > 0.0) {
            traced++;
            if (walls.trace(ray.originX, ray.originY, ray.originZ, point.x, point.y, point.z, ray.medium)) {
                double leg = Connections.betweenSurfaces(here, there, distance);
                double weight = walls.isFree()
                        ? Connections.weight(leg, point.reluctance + arrival.reluctance(point.scatterings, point.order))
                        : Connections.weight(Connections.throughWalls(leg), point.reluctance);
                double geometry = weight * 4.0 * here * there / (Math.PI * distance * distance);
                for (int band = 0; band < BANDS; band++) {
                    brought[band] = leaving[band]
                            * surfaces.scatteredTo(material, band, here)
                            * point.energy[band]
                            * surfaces.scatteredTo(point.material, band, there)
                            * geometry
                            * walls.passed(band)
                            * air.left(band, distance);
                }
                tally.add(ray, brought, distance + point.distance);
            }
        }
        MirrorChains chains = ends.ofSource();
        for (int chain = 1; chain < chains.count(); chain++) {
            if (ray.order + point.order + chains.order(chain) <= maxOrder
                    && path.follow(chains, point.images, chain, ray.originX, ray.originY, ray.originZ)) {
                joinOver(chain, ray, normal, material, leaving, arrival, point);
            }
        }
    }

    private void joinOver(
            int chain,
            AcousticRay ray,
            double[] normal,
            int material,
            double[] leaving,
            Arrival arrival,
            ScatteredSound.Point point) {
        traced += ends.ofSource().order(chain) + 1;
        double here = path.cosineAtBeginning(normal);
        double there = path.cosineAtEnd(point.normal[0], point.normal[1], point.normal[2]);
        if (!(here > 0.0 && there > 0.0)) {
            return;
        }
        double distance = path.length();
        double weight = Connections.weight(
                Connections.betweenSurfaces(here, there, distance),
                point.reluctance
                        + arrival.reluctance(
                                point.scatterings, point.order + ends.ofSource().order(chain)));
        double geometry = weight * 4.0 * here * there / (Math.PI * distance * distance);
        for (int band = 0; band < BANDS; band++) {
            brought[band] = leaving[band]
                    * surfaces.scatteredTo(material, band, here)
                    * point.energy[band]
                    * surfaces.scatteredTo(point.material, band, there)
                    * geometry
                    * path.reflected(band)
                    * air.left(band, distance);
        }
        tally.add(ray, brought, distance + point.distance);
    }

    /**
     * Adds what the points where a ray from the source was scattered first send to the sensor.
     *
     * @return how many connections were tried
     */
    int addFrom(ScatteredSound scattered, AcousticRay scratch) {
        traced = 0;
        for (int i = 0; i < scattered.count(); i++) {
            addFrom(scattered.point(i), scratch);
        }
        return traced;
    }

    private void addFrom(ScatteredSound.Point point, AcousticRay scratch) {
        Position sensor = ends.sensor();
        double x = sensor.x() - point.x;
        double y = sensor.y() - point.y;
        double z = sensor.z() - point.z;
        double distance = Math.sqrt(x * x + y * y + z * z);
        double cosine = (x * point.normal[0] + y * point.normal[1] + z * point.normal[2]) / distance;
        scratch.travelled = point.distance;
        if (cosine > 0.0) {
            traced++;
            // From the sensor, as rays come: so the surface is at the far end of both.
            if (walls.trace(sensor.x(), sensor.y(), sensor.z(), point.x, point.y, point.z, AcousticRay.AIR)) {
                double leg = Connections.fromPoint(cosine, distance);
                double weight =
                        Connections.weight(walls.isFree() ? leg : Connections.throughWalls(leg), point.reluctance);
                double geometry = weight * cosine / (Math.PI * distance * distance);
                for (int band = 0; band < BANDS; band++) {
                    brought[band] = ends.source().fraction(band)
                            * point.energy[band]
                            * surfaces.scatteredTo(point.material, band, cosine)
                            * geometry
                            * walls.passed(band)
                            * air.left(band, distance);
                }
                tally.add(scratch, brought, distance);
            }
        }
        MirrorChains chains = ends.ofSensor();
        for (int chain = 1; chain < chains.count(); chain++) {
            if (point.order + chains.order(chain) <= maxOrder
                    && path.follow(chains, imagesOfSensor, chain, point.x, point.y, point.z)) {
                addOver(chain, point, scratch);
            }
        }
    }

    private void addOver(int chain, ScatteredSound.Point point, AcousticRay scratch) {
        traced += ends.ofSensor().order(chain) + 1;
        double cosine = path.cosineAtBeginning(point.normal);
        if (!(cosine > 0.0)) {
            return;
        }
        double distance = path.length();
        double weight = Connections.weight(Connections.fromPoint(cosine, distance), point.reluctance);
        double geometry = weight * cosine / (Math.PI * distance * distance);
        for (int band = 0; band < BANDS; band++) {
            brought[band] = ends.source().fraction(band)
                    * point.energy[band]
                    * surfaces.scatteredTo(point.material, band, cosine)
                    * geometry
                    * path.reflected(band)
                    * air.left(band, distance);
        }
        tally.add(scratch, brought, distance);
    }
}
