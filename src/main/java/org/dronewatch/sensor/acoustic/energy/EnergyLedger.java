package org.dronewatch.sensor.acoustic.energy;

/** Records where the energy of rays goes. One per thread. */
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

    /** Adds the account of other rays. */
    void add(EnergyLedger others) {
        gained += others.gained;
        absorbed += others.absorbed;
        air += others.air;
        escaped += others.escaped;
        lost += others.lost;
        residual += others.residual;
    }

    /** Stays in a surface. */
    void absorb(double energy) {
        absorbed += energy;
    }

    /** Stays in the air. */
    void leaveToAir(double energy) {
        air += energy;
    }

    /** Leaves the site. */
    void escape(double energy) {
        escaped += energy;
    }

    /** Is truncated at the maximum order. */
    void giveUp(double energy) {
        residual += energy;
    }

    /** Chance has turned one energy into another: by a choice among branches, or by the roulette. */
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
