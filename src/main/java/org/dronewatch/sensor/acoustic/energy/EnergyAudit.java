package org.dronewatch.sensor.acoustic.energy;

/**
 * The energy balance of the rays, as fractions of the emitted energy: emitted + gained = absorbed + air + escaped +
 * lost + residual.
 *
 * @param emitted energy emitted by the source: 1, since all parts are fractions of it; 0 for a reading without rays
 * @param gained energy added to surviving rays by Russian roulette and branch selection
 * @param absorbed energy absorbed by surfaces
 * @param air energy absorbed in the air
 * @param escaped energy that left the site
 * @param lost energy of rays terminated by Russian roulette and branch selection
 * @param residual energy that rays had left when they ended at the maximum order
 */
public record EnergyAudit(
        double emitted, double gained, double absorbed, double air, double escaped, double lost, double residual) {

    /** The imbalance: 0 except for rounding. */
    public double imbalance() {
        return emitted + gained - absorbed - air - escaped - lost - residual;
    }
}
