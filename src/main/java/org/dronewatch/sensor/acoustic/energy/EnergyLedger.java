package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.BandFactors;
import org.dronewatch.sound.OctaveBands;

/** Records where the energy of rays goes. For use by one thread. */
final class EnergyLedger {
    private final double[] absorbed = new double[OctaveBands.COUNT];
    private final double[] air = new double[OctaveBands.COUNT];
    private double gained;
    private double escaped;
    private double lost;
    private double residual;

    void clear() {
        gained = 0.0;
        Arrays.fill(absorbed, 0.0);
        Arrays.fill(air, 0.0);
        escaped = 0.0;
        lost = 0.0;
        residual = 0.0;
    }

    /** Adds the entries of another ledger. */
    void add(EnergyLedger others) {
        gained += others.gained;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            absorbed[band] += others.absorbed[band];
            air[band] += others.air[band];
        }
        escaped += others.escaped;
        lost += others.lost;
        residual += others.residual;
    }

    /** The energy that surfaces have absorbed, by band; to be added to. */
    double[] absorbedByBand() {
        return absorbed;
    }

    /** The energy that the air has absorbed, by band; to be added to. */
    double[] airByBand() {
        return air;
    }

    /** Records energy that leaves the site. */
    void escape(double energy) {
        escaped += energy;
    }

    /** Records energy that is truncated at the maximum order. */
    void giveUp(double energy) {
        residual += energy;
    }

    /** Records that a random choice turned one energy into another: among branches, or by the roulette. */
    void exchange(double before, double after) {
        gained += Math.max(0.0, after - before);
        lost += Math.max(0.0, before - after);
    }

    /**
     * The fractions of the emitted energy.
     *
     * @param emitted energy emitted by all rays together
     */
    EnergyAudit audit(double emitted) {
        return new EnergyAudit(
                1.0,
                gained / emitted,
                BandFactors.sum(absorbed) / emitted,
                BandFactors.sum(air) / emitted,
                escaped / emitted,
                lost / emitted,
                residual / emitted);
    }
}
