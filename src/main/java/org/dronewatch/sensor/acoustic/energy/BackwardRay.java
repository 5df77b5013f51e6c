package org.dronewatch.sensor.acoustic.energy;

import java.util.random.RandomGenerator;
import org.dronewatch.bvh.RayPacket;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.imagesource.CrossedFaces;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * One ray that is followed to its end: backward from the sensor or, if that is the start (see {@link Ends}), from the
 * source. A surface absorbs part of its energy; the rest goes on as one ray, which is reflected specularly, scattered
 * by Lambert's law or transmitted through the wall: this is drawn at random so that the mean is right. If walls hide
 * the target, the ray is divided instead where a wall transmits sound, and both parts go on. Where the ray is
 * scattered, it is connected to the target; where it passes the target after specular reflections, it is counted in a
 * sphere around the target, unless its path is computed exactly or was connected before. For use by one thread.
 */
final class BackwardRay {
    /**
     * Up to this order, every surface that scatters is connected to the target; later surfaces are connected only if
     * the ray is scattered there.
     */
    private static final int ALWAYS_JOINED = 2;

    private final EnergyModel model;
    private final World world;
    private final Normals normals;
    private final RayTracer traversal;
    private final BandSurfaces surfaces;
    private final WallPlanes planes;
    private final CrossedFaces faces;
    private final ReceiverSphere ofTarget;
    private final ReceiverSphere ofStart;
    private final DiffuseConnection connection;
    private final EnergyPacket energy;
    private final Arrival arrival = new Arrival();
    private final AcousticRay ray = new AcousticRay();
    private final RecordedRay recorded;
    private final double[] normal = new double[3];
    private final double[] emitted = new double[OctaveBands.COUNT];

    private Ends ends;
    private ScatteredSound scattered;
    private RandomGenerator random;
    private int traced;

    private final double[] through = new double[OctaveBands.COUNT];
    private final PartOfRay arriving = new PartOfRay();

    /** The parts that walls reflected: they wait until the transmitted part has ended. */
    private final WaitingParts waiting = new WaitingParts();

    /** Whether the last interaction was a specular reflection: such rays cannot be connected to a point. */
    private boolean fromMirror;

    /**
     * Rays from one end.
     *
     * @param ofTarget the sphere around the target
     * @param ofStart the sphere around the start
     * @param connection connects scattered rays to the target
     * @param energy energy of the ray
     */
    BackwardRay(
            EnergyModel model,
            World world,
            WallPlanes planes,
            BandSurfaces surfaces,
            ReceiverSphere ofTarget,
            ReceiverSphere ofStart,
            DiffuseConnection connection,
            EnergyPacket energy) {
        this.model = model;
        this.world = world;
        this.normals = new Normals(world.mesh());
        this.traversal = world.newIncoherentRayTracer();
        this.surfaces = surfaces;
        this.faces = new CrossedFaces(world, surfaces);
        this.planes = planes;
        this.ofTarget = ofTarget;
        this.ofStart = ofStart;
        this.connection = connection;
        this.energy = energy;
        this.recorded = new RecordedRay(model, ray, energy);
    }

    /**
     * Starts one ray.
     *
     * @param near points at which a ray from the target was scattered
     */
    void start(Ends both, ScatteredSound near, RandomGenerator chance, RayRecorder listener) {
        ends = both;
        scattered = near;
        random = chance;
        recorded.begin(both, listener);
        traced = 0;
        waiting.clear();
        ray.originX = ends.start().x();
        ray.originY = ends.start().y();
        ray.originZ = ends.start().z();
        Directions.draw(random, ray);
        energy.fill(ends, ray.directionZ);
        ray.travelled = 0.0;
        ray.order = 0;
        fromMirror = false;
        arrival.start(ends, ofStart, ray);
    }

    /** Traces the next segment and follows the ray to its end; returns whether it goes on. */
    boolean goOn() {
        boolean hit = ray.meets(traversal);
        return goOn(hit, traversal.triangle(), traversal.distance());
    }

    /** Puts the next segment into a packet. */
    void put(RayPacket packet, int number) {
        packet.set(number, ray.originX, ray.originY, ray.originZ, ray.directionX, ray.directionY, ray.directionZ);
    }

    /**
     * Follows the ray along its next segment.
     *
     * @param hit whether the segment ends at a triangle
     * @return whether the ray goes on from there
     */
    boolean goOn(boolean hit, int triangle, double length) {
        traced++;
        double distance = hit ? length : Double.POSITIVE_INFINITY;
        // Only the few rays that pass the target need to be looked up among the exact paths.
        if (fromMirror && ofTarget.mayBeCrossed(ray) && !arrival.isExact()) {
            countPassing(distance);
        }
        recorded.flight(distance);
        if (!hit) {
            energy.escape();
            return false;
        }
        energy.travel(distance);
        ray.travelled += distance;
        if (ray.order >= model.maxOrder()) {
            energy.giveUp();
            return false;
        }
        meet(triangle, distance);
        return energy.playRoulette(random);
    }

    /** The number of segments traced since the start. */
    int traced() {
        return traced;
    }

    private void countPassing(double end) {
        if (!ofTarget.isCrossed(ray, arrival.leg(), end, random)) {
            return;
        }
        recorded.arrival();
        for (int band = 0; band < emitted.length; band++) {
            emitted[band] = energy.byBand()[band] * ends.targetFactor(band, ofTarget.rise()) * corrected(band);
        }
        ofTarget.count(ray, emitted, arrival.inverseDensityBefore());
    }

    /**
     * The energy of a ray in a band, corrected for the path to the target itself if the ray has not been scattered:
     * this includes the directivity with which the start emits.
     */
    private double corrected(int band) {
        if (!ends.isFromSource() || !arrival.isFromStart()) {
            return 1.0;
        }
        return ends.startFactor(band, ofTarget.riseFromBeginning())
                / ends.startFactor(band, arrival.leg().riseFromBeginning());
    }

    private void meet(int triangle, double distance) {
        normals.facing(triangle, ray, normal);
        ray.advance(distance);
        int material = world.material(triangle, ray.originX, ray.originY);
        ray.order++;
        double cosine = -along();
        arrival.meet(distance, cosine, ray.order);
        if (surfaces.transmits(material)) {
            meetFaces(triangle, material, cosine);
        } else {
            meetFace(triangle, material, cosine);
        }
    }

    /** Passes the ray through all faces that coincide here, unless one of them reflects it. */
    private void meetFaces(int triangle, int material, double cosine) {
        faces.find(triangle, material, ray);
        for (int i = 0; i < faces.count(); i++) {
            // The ray leaves a solid: the loss was applied on entry.
            boolean begins = faces.begins(i, arrival.solids());
            if (begins && !meetFace(faces.triangle(i), faces.material(i), cosine)) {
                return;
            }
        }
        faces.pass(arrival.solids());
        arrival.passThrough();
        ray.advance(faces.beyond());
        ray.standOff(normal, -1.0);
    }

    /** Whether the ray is transmitted; otherwise it is reflected. */
    private boolean meetFace(int triangle, int material, double cosine) {
        if (ends.isThroughWalls() && surfaces.transmits(material) && !waiting.isFull()) {
            return divide(triangle, material, cosine);
        }
        if (energy.drawTransmission(material, cosine, random)) {
            return true;
        }
        ray.standOff(normal, 1.0);
        reflect(triangle, material);
        return false;
    }

    /**
     * Divides the ray into a part that goes on behind the wall and one that is reflected, which waits. If they were
     * alternatives, a ray would hardly ever get through most walls.
     *
     * @return whether a part goes on behind the wall
     */
    private boolean divide(int triangle, int material, double cosine) {
        if (!energy.divide(material, cosine, through)) {
            ray.standOff(normal, 1.0);
            reflect(triangle, material);
            return false;
        }
        arriving.save(ray, arrival, through, fromMirror);
        ray.standOff(normal, 1.0);
        reflect(triangle, material);
        if (energy.playRoulette(random)) {
            waiting.next().save(ray, arrival, energy.byBand(), fromMirror);
        }
        restore(arriving);
        return true;
    }

    private void restore(PartOfRay part) {
        ray.copy(part.ray);
        arrival.copy(part.arrival);
        energy.set(part.energy);
        fromMirror = part.fromMirror;
    }

    /** Continues with a part of the ray that has waited; returns false if there is none. */
    boolean resume() {
        boolean isWaiting = !waiting.isEmpty();
        if (isWaiting) {
            restore(waiting.last());
        }
        return isWaiting;
    }

    private void reflect(int triangle, int material) {
        if (arrival.isMerging()
                && surfaces.scatters(material)
                && connection.merged().mayAdd(ray, scattered)) {
            connection.merged().add(ray, normal, material, energy.scatteredBy(material), arrival, scattered);
        }
        boolean always = ray.order <= ALWAYS_JOINED && surfaces.scatters(material);
        if (always) {
            join(triangle, material, energy.scatteredBy(material));
        }
        if (energy.drawScattering(material, random)) {
            if (!always) {
                join(triangle, material, energy.byBand());
            }
            Directions.drawLambert(random, normal, ray);
            energy.scatter(material, along());
            arrival.scatter(ray, along());
            fromMirror = false;
        } else {
            ray.reflect(normal);
            arrival.reflect(planes.wallOf(triangle));
            fromMirror = true;
        }
    }

    private void join(int triangle, int material, double[] leaving) {
        traced += connection.add(ray, planes.wallOf(triangle), normal, material, leaving, arrival, scattered);
        if (connection.isJoined()) {
            recorded.arrival();
        }
    }

    /** The component of the ray's direction along the normal. */
    private double along() {
        return ray.directionX * normal[0] + ray.directionY * normal[1] + ray.directionZ * normal[2];
    }
}
