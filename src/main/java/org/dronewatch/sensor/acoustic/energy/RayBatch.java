package org.dronewatch.sensor.acoustic.energy;

import java.util.random.RandomGenerator;
import org.dronewatch.bvh.RayPacket;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.world.World;

/** Traces a batch of a reading's rays and keeps the results. For use by one thread. */
final class RayBatch {
    private final EnergyModel model;
    private final WallPlanes planes;
    private final EnergyTally tally;
    private final EnergyLedger ledger = new EnergyLedger();
    private final BackwardRay ray;
    private final ReceiverSphere ofTarget;
    private final ReceiverSphere ofStart;
    private final DiffuseConnection connection;
    private final ScatteredSound scattered;
    private final AcousticRay scratch = new AcousticRay();
    private Ends ends;
    private RandomGenerator random;
    private RayRecorder recorder;
    private int left;
    private long traced;

    RayBatch(EnergyModel model, double radius, World world, WallPlanes planes, BandSurfaces surfaces, Air air) {
        this.model = model;
        this.planes = planes;
        this.tally = new EnergyTally(air);
        this.ofTarget = new ReceiverSphere(radius, world, planes, surfaces, air, tally);
        this.ofStart = new ReceiverSphere(radius, world, planes, surfaces, air, tally);
        this.connection = new DiffuseConnection(model, radius, world, planes, surfaces, air, tally);
        this.ray = new BackwardRay(
                model,
                world,
                planes,
                surfaces,
                ofTarget,
                ofStart,
                connection,
                new EnergyPacket(model, surfaces, air, ledger));
        this.scattered = new ScatteredSound(world, planes, surfaces, ofTarget, ofStart, air);
    }

    /** Begins to trace a number of rays, 1 or more; discards the results of the previous ones. */
    void begin(Ends both, int rays, RandomGenerator chance, RayRecorder listener) {
        ends = both;
        random = chance;
        recorder = listener;
        left = rays;
        tally.clear();
        ledger.clear();
        traced = 0;
        double known = ends.isOpen() ? ends.known() : Double.POSITIVE_INFINITY;
        ofTarget.surround(ends.target(), known);
        ofStart.surround(ends.start(), known);
        connection.seek(ends, planes);
        startRay();
    }

    private void startRay() {
        traced += scattered.follow(ends, model.maxOrder(), random);
        traced += connection.addFrom(scattered, scratch);
        ray.start(ends, scattered, random, recorder);
    }

    /** Whether all rays have ended. */
    boolean isDone() {
        return left == 0;
    }

    /** Traces all rays to their ends. */
    void finish() {
        while (!isDone()) {
            count(ray.goOn());
        }
    }

    /** Puts the next segment into a packet. */
    void put(RayPacket packet, int number) {
        ray.put(packet, number);
    }

    /** Continues from the end of the segment that was put into a packet. */
    void take(RayPacket packet, int number) {
        count(ray.goOn(packet.isHit(number), packet.triangle(number), packet.distance(number)));
    }

    private void count(boolean goesOn) {
        if (goesOn || ray.resume()) {
            return;
        }
        traced += ray.traced();
        tally.endRay();
        left--;
        if (left > 0) {
            startRay();
        }
    }

    /** The contributions of the rays. */
    EnergyTally tally() {
        return tally;
    }

    /** The record of where the energy of the rays went. */
    EnergyLedger ledger() {
        return ledger;
    }

    /** The number of ray segments traced. */
    long traced() {
        return traced;
    }
}
