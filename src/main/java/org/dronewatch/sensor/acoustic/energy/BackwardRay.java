package org.dronewatch.sensor.acoustic.energy;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.Levels;
import org.dronewatch.world.World;

/**
 * One ray traced backward from the sensor. A surface absorbs part of its energy; the rest goes on as one ray, reflected
 * specularly, scattered by Lambert's law or transmitted through the wall, drawn at random so that the mean is right.
 * Where the ray is scattered, it is connected to the source; where it passes the source after a specular reflection, it
 * is counted in a sphere about the source, unless its path is one of those that are computed exactly. One per thread.
 */
final class BackwardRay {
    private static final double STAND_OFF = 1e-9;

    /**
     * Up to this order every surface that scatters is connected to the source, later ones only if the ray is scattered
     * there.
     */
    private static final int ALWAYS_JOINED = 2;

    /** How far rays that meet nothing are drawn, m. */
    private static final double DRAWN = 1000.0;

    /** Instead of the number of specular reflections: marks a path that is not purely specular. */
    private static final int NOT_EXACT = -1;

    private final EnergyModel model;
    private final Position sensor;
    private final TriangleMesh mesh;
    private final RayTracer traversal;
    private final BandSurfaces surfaces;
    private final WallPlanes planes;
    private final ReceiverSphere receiver;
    private final DiffuseConnection connection;
    private final EnergyPacket energy;
    private final AcousticRay ray = new AcousticRay();
    private final double[] normal = new double[3];

    private SoundSource source;
    private RandomGenerator random;
    private RayRecorder recorder;
    private int traced;

    /** Whether the last interaction was a specular reflection: such rays cannot be connected to a point source. */
    private boolean fromMirror;

    /** The number of specular reflections of the ray, if it is purely specular. */
    private int mirrors;

    /** Whether all specular reflections so far were in large walls. */
    private boolean largeWallsOnly;

    /**
     * Rays from one sensor.
     *
     * @param radius of the sphere about the source, m
     * @param tally accumulates what rays contribute
     * @param ledger records where their energy goes
     */
    BackwardRay(
            EnergyModel model,
            Position sensor,
            double radius,
            World world,
            WallPlanes planes,
            BandSurfaces surfaces,
            Air air,
            EnergyTally tally,
            EnergyLedger ledger) {
        this.model = model;
        this.sensor = sensor;
        this.mesh = world.mesh();
        this.traversal = world.newIncoherentRayTracer();
        this.surfaces = surfaces;
        this.planes = planes;
        this.receiver = new ReceiverSphere(radius, air, tally);
        this.connection = new DiffuseConnection(world, surfaces, air, tally);
        this.energy = new EnergyPacket(model, surfaces, air, ledger);
    }

    /** Prepares for rays that look for a source. */
    void seek(SoundSource next) {
        receiver.surround(next.position(), traversal);
    }

    /** Follows one ray to its end, looking for the source that is sought; returns the number of segments traced. */
    int follow(SoundSource from, RandomGenerator chance, RayRecorder listener) {
        source = from;
        random = chance;
        recorder = listener;
        traced = 0;

        start();
        while (true) {
            boolean hit = traversal.closestHit(
                    ray.originX,
                    ray.originY,
                    ray.originZ,
                    ray.directionX,
                    ray.directionY,
                    ray.directionZ,
                    0.0,
                    Double.POSITIVE_INFINITY);
            traced++;
            double distance = hit ? traversal.distance() : Double.POSITIVE_INFINITY;
            if (fromMirror && !isExact()) {
                receiver.count(ray, energy.byBand(), distance, source);
            }
            recordFlight(Math.min(distance, DRAWN));
            if (!hit) {
                energy.escape();
                return traced;
            }
            energy.fly(distance);
            ray.travelled += distance;
            if (ray.order >= model.maxOrder()) {
                energy.giveUp();
                return traced;
            }
            meet(traversal.triangle(), distance);
            if (!energy.playRoulette(random)) {
                return traced;
            }
        }
    }

    private void start() {
        energy.fill(source);
        ray.originX = sensor.x();
        ray.originY = sensor.y();
        ray.originZ = sensor.z();
        Directions.draw(random, ray);
        ray.travelled = 0.0;
        ray.order = 0;
        ray.medium = AcousticRay.AIR;
        fromMirror = false;
        mirrors = 0;
        largeWallsOnly = true;
    }

    /** Whether a path straight on to the source is one of those that are computed exactly. */
    private boolean isExact() {
        return mirrors == 1 || mirrors > 1 && largeWallsOnly && mirrors <= model.imageSourceOrder();
    }

    private void recordFlight(double length) {
        if (recorder != RayRecorder.NONE) {
            record(
                    ray.originX + length * ray.directionX,
                    ray.originY + length * ray.directionY,
                    ray.originZ + length * ray.directionZ,
                    false);
        }
    }

    private void recordConnection() {
        if (recorder != RayRecorder.NONE) {
            Position position = source.position();
            record(position.x(), position.y(), position.z(), true);
        }
    }

    /** The level of a segment is that of the fraction of the source's power which it carries. */
    private void record(double toX, double toY, double toZ, boolean received) {
        double level = Levels.ofRatio(energy.all() * source.emitted() / model.rays());
        recorder.record(ray.originX, ray.originY, ray.originZ, toX, toY, toZ, level, ray.order, received);
    }

    private void meet(int triangle, double distance) {
        int material = mesh.material(triangle);
        Normals.facing(mesh, triangle, ray, normal);
        ray.originX += distance * ray.directionX;
        ray.originY += distance * ray.directionY;
        ray.originZ += distance * ray.directionZ;
        ray.order++;
        if (ray.medium == material) {
            // Out of a solid: its loss was taken on entry.
            ray.medium = AcousticRay.AIR;
            mirrors = NOT_EXACT;
            standOff(-1.0);
            return;
        }
        if (energy.drawTransmission(material, -along(), random)) {
            ray.medium = surfaces.isSheet(material) ? ray.medium : material;
            mirrors = NOT_EXACT;
            standOff(-1.0);
        } else {
            standOff(1.0);
            reflect(triangle, material);
        }
    }

    private void reflect(int triangle, int material) {
        boolean always = ray.order <= ALWAYS_JOINED && surfaces.scatters(material);
        if (always) {
            join(material, energy.scatteredBy(material));
        }
        if (energy.drawScattering(material, random)) {
            if (!always) {
                join(material, energy.byBand());
            }
            Directions.drawLambert(random, normal, ray);
            energy.scatter(material, along());
            fromMirror = false;
            mirrors = NOT_EXACT;
        } else {
            mirror();
            fromMirror = true;
            mirrors = mirrors == NOT_EXACT ? NOT_EXACT : mirrors + 1;
            largeWallsOnly = largeWallsOnly && planes.wallOf(triangle) != WallPlanes.NONE;
        }
    }

    private void join(int material, double[] leaving) {
        traced++;
        if (connection.add(ray, normal, material, leaving, source)) {
            recordConnection();
        }
    }

    /** The part of the ray's direction along the normal. */
    private double along() {
        return ray.directionX * normal[0] + ray.directionY * normal[1] + ray.directionZ * normal[2];
    }

    private void mirror() {
        double twice = 2.0 * along();
        ray.directionX -= twice * normal[0];
        ray.directionY -= twice * normal[1];
        ray.directionZ -= twice * normal[2];
    }

    private void standOff(double side) {
        double far = 1.0 + Math.abs(ray.originX) + Math.abs(ray.originY) + Math.abs(ray.originZ);
        double step = side * STAND_OFF * far;
        ray.originX += step * normal[0];
        ray.originY += step * normal[1];
        ray.originZ += step * normal[2];
    }
}
