package org.dronewatch.sensor.acoustic.energy;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.world.World;

/** Traces some rays of a reading and keeps what they found until it is asked for. One per thread. */
final class RayBatch {
    private final EnergyModel model;
    private final Position sensor;
    private final EnergyTally tally;
    private final EnergyLedger ledger = new EnergyLedger();
    private final BackwardRay ray;
    private final FirstScattering firstScattering;
    private long traced;

    RayBatch(
            EnergyModel model,
            Position sensor,
            double radius,
            World world,
            WallPlanes planes,
            BandSurfaces surfaces,
            Air air) {
        this.model = model;
        this.sensor = sensor;
        this.tally = new EnergyTally(air);
        this.ray = new BackwardRay(model, sensor, radius, world, planes, surfaces, air, tally, ledger);
        this.firstScattering = new FirstScattering(world, surfaces, air, tally);
    }

    /** Traces a number of rays; discards the results of the previous ones. */
    void trace(SoundSource source, int rays, RandomGenerator random, RayRecorder recorder) {
        tally.clear();
        ledger.clear();
        traced = 0;
        ray.seek(source);
        for (int i = 0; i < rays; i++) {
            traced += ray.follow(source, random, recorder);
            // Paths found by the source's rays have hit one surface, too.
            traced += model.maxOrder() > 0 ? firstScattering.add(source, sensor, random) : 0;
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
