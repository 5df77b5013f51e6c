package org.dronewatch.sensor.acoustic.energy;

/**
 * Where the energy of the rays went, as shares of what was emitted: what chance added and what was emitted must be what
 * was lost.
 *
 * @param emitted what left the source: 1 for each band with sound in it, all bands together 1
 * @param gained what surviving rays were given by the roulette and by the choice among branches
 * @param absorbed what stayed in surfaces
 * @param air what stayed in the air
 * @param escaped what left the site
 * @param lost what ended by the roulette and by the choice among branches
 * @param residual what was given up at the largest order
 */
public record EnergyAudit(
        double emitted, double gained, double absorbed, double air, double escaped, double lost, double residual) {

    /** What is unaccounted for: 0 but for rounding. */
    public double imbalance() {
        return emitted + gained - absorbed - air - escaped - lost - residual;
    }
}
