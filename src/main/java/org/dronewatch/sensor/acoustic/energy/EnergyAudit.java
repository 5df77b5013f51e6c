package org.dronewatch.sensor.acoustic.energy;

/**
 * The energy balance of the rays, as fractions of the emitted energy: emitted + gained = absorbed + air + escaped +
 * lost + residual.
 *
 * @param emitted emitted by the source: 1 for each band with sound, 1 for all bands together
 * @param gained added to surviving rays by Russian roulette and branch selection
 * @param absorbed absorbed in surfaces
 * @param air absorbed in the air
 * @param escaped left the site
 * @param lost of rays terminated by Russian roulette and branch selection
 * @param residual of rays truncated at the maximum order
 */
public record EnergyAudit(
        double emitted, double gained, double absorbed, double air, double escaped, double lost, double residual) {

    /** The imbalance: 0 except for rounding. */
    public double imbalance() {
        return emitted + gained - absorbed - air - escaped - lost - residual;
    }
}
