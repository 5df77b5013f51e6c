package org.dronewatch.sensor.acoustic.energy;

import java.util.random.RandomGenerator;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.world.World;

/** Traces a batch of a reading's rays and keeps the results. One per thread. */
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
    private long traced;

    RayBatch(EnergyModel model, double radius, World world, WallPlanes planes, BandSurfaces surfaces, Air air) {
        this.model = model;
        this.planes = planes;
        this.tally = new EnergyTally(air);
        this.ofTarget = new ReceiverSphere(radius, world, planes, surfaces, air, tally);
        this.ofStart = new ReceiverSphere(radius, world, planes, surfaces, air, tally);
        this.connection = new DiffuseConnection(model, world, planes, surfaces, air, tally);
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

    /** Traces a number of rays; discards the results of the previous ones. */
    void trace(Ends ends, int rays, RandomGenerator random, RayRecorder recorder) {
        tally.clear();
        ledger.clear();
        traced = 0;
        double known = ends.isOpen() ? ends.known() : Double.POSITIVE_INFINITY;
        ofTarget.surround(ends.target(), known);
        ofStart.surround(ends.start(), known);
        connection.seek(ends, planes);
        for (int i = 0; i < rays; i++) {
            traced += scattered.follow(ends, model.maxOrder(), random);
            traced += connection.addFrom(scattered, scratch);
            traced += ray.follow(ends, scattered, random, recorder);
            tally.endRay();
        }
    }

    /** What the rays contributed. */
    EnergyTally tally() {
        return tally;
    }

    /** Where their energy went. */
    EnergyLedger ledger() {
        return ledger;
    }

    /** The number of ray segments traced. */
    long traced() {
        return traced;
    }
}
