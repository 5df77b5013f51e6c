package org.dronewatch.sensor.acoustic.energy;

/** Records where the energy of rays goes. For use by one thread. */
final class EnergyLedger {
    private double gained;
    private double absorbed;
    private double air;
    private double escaped;
    private double lost;
    private double residual;

    void clear() {
        gained = 0.0;
        absorbed = 0.0;
        air = 0.0;
        escaped = 0.0;
        lost = 0.0;
        residual = 0.0;
    }

    /** Adds the entries of another ledger. */
    void add(EnergyLedger others) {
        gained += others.gained;
        absorbed += others.absorbed;
        air += others.air;
        escaped += others.escaped;
        lost += others.lost;
        residual += others.residual;
    }

    /** Records energy that a surface absorbs. */
    void absorb(double energy) {
        absorbed += energy;
    }

    /** Records energy that the air absorbs. */
    void leaveToAir(double energy) {
        air += energy;
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
     * @param emitted by all rays together
     */
    EnergyAudit audit(double emitted) {
        return new EnergyAudit(
                1.0,
                gained / emitted,
                absorbed / emitted,
                air / emitted,
                escaped / emitted,
                lost / emitted,
                residual / emitted);
    }
}
