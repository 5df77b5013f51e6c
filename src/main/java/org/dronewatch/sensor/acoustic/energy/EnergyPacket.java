package org.dronewatch.sensor.acoustic.energy;

import java.util.random.RandomGenerator;
import org.dronewatch.sensor.acoustic.propagation.BandFactors;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;

/**
 * The energy that a ray carries in each band, and how air, surfaces and random choices change it. One branch is drawn
 * for all bands, according to their total energy; each band is then weighted so that its mean is right. For use by one
 * thread.
 */
final class EnergyPacket {
    private static final int BANDS = OctaveBands.COUNT;
    private static final double SURVIVAL = 0.5;

    private final EnergyModel model;
    private final BandSurfaces surfaces;
    private final Air air;
    private final EnergyLedger ledger;
    private final double[] energy = new double[BANDS];
    private final double[] scattered = new double[BANDS];

    private double faint;

    EnergyPacket(EnergyModel model, BandSurfaces surfaces, Air air, EnergyLedger ledger) {
        this.model = model;
        this.surfaces = surfaces;
        this.air = air;
        this.ledger = ledger;
    }

    /**
     * Sets the energies to those that a ray carries at first.
     *
     * @param rise sine of the elevation at which the ray leaves
     */
    void fill(Ends ends, double rise) {
        for (int band = 0; band < BANDS; band++) {
            energy[band] = ends.source().fraction(band);
        }
        double first = all();
        faint = ends.roulette() * first;
        if (ends.isFromSource()) {
            for (int band = 0; band < BANDS; band++) {
                energy[band] *= ends.startFactor(band, rise);
            }
            ledger.exchange(first, all());
        }
    }

    /** The energies by band; not to be modified. */
    double[] byBand() {
        return energy;
    }

    /** The energy in all bands, added up anew. */
    double all() {
        return BandFactors.sum(energy);
    }

    /** Deducts the energy that the air absorbs over a distance, m. */
    void travel(double distance) {
        air.attenuate(energy, distance, ledger.airByBand());
    }

    /** Records that the packet has left the site. */
    void escape() {
        ledger.escape(all());
    }

    /** Records that the packet is truncated at the maximum order. */
    void giveUp() {
        ledger.giveUp(all());
    }

    /**
     * Deducts the energy that a surface absorbs, and draws whether the rest is transmitted or reflected.
     *
     * @param cosine cosine of the angle between the sound and the normal
     * @return whether it is transmitted
     */
    boolean drawTransmission(int material, double cosine, RandomGenerator random) {
        if (!surfaces.transmits(material)) {
            surfaces.reflect(material, cosine, energy, ledger.absorbedByBand());
            return false;
        }
        double[] absorbed = ledger.absorbedByBand();
        double reflected = 0.0;
        double transmitted = 0.0;
        for (int band = 0; band < BANDS; band++) {
            double turned = energy[band] * surfaces.reflected(material, band, cosine);
            double through = energy[band] * surfaces.transmitted(material, band);
            absorbed[band] += energy[band] - turned - through;
            reflected += turned;
            transmitted += through;
        }
        double onward = reflected + transmitted;
        double chance = onward > 0.0 ? transmitted / onward : 0.0;
        boolean isTransmitted = random.nextDouble() < chance;
        for (int band = 0; band < BANDS; band++) {
            energy[band] *= isTransmitted
                    ? surfaces.transmitted(material, band) / chance
                    : surfaces.reflected(material, band, cosine) / (1.0 - chance);
        }
        ledger.exchange(onward, all());
        return isTransmitted;
    }

    /**
     * Deducts the energy that a surface absorbs, and that which it transmits.
     *
     * @param cosine cosine of the angle between the sound and the normal
     * @param through receives the energies that it transmits, by band
     * @return whether it transmits any
     */
    boolean divide(int material, double cosine, double[] through) {
        double[] absorbed = ledger.absorbedByBand();
        double transmitted = 0.0;
        for (int band = 0; band < BANDS; band++) {
            double turned = energy[band] * surfaces.reflected(material, band, cosine);
            through[band] = energy[band] * surfaces.transmitted(material, band);
            absorbed[band] += energy[band] - turned - through[band];
            energy[band] = turned;
            transmitted += through[band];
        }
        return transmitted > 0.0;
    }

    /** Sets the energies by band. */
    void set(double[] energies) {
        System.arraycopy(energies, 0, energy, 0, BANDS);
    }

    /** The energy that a surface would scatter, by band; valid until the next call. */
    double[] scatteredBy(int material) {
        for (int band = 0; band < BANDS; band++) {
            scattered[band] = energy[band] * surfaces.scattered(material, band);
        }
        return scattered;
    }

    /**
     * Draws whether the sound that a surface reflects is scattered or reflected specularly.
     *
     * @return whether it is scattered
     */
    boolean drawScattering(int material, RandomGenerator random) {
        if (surfaces.isEvenlyScattering(material)) {
            // The branch has the same chance in all bands: none needs a weight.
            return random.nextDouble() < surfaces.scattered(material, 0);
        }
        double before = all();
        double chance = before > 0.0 ? surfaces.chanceOfScattering(material, energy) : 0.0;
        boolean diffuse = random.nextDouble() < chance;
        double weight = diffuse ? 1.0 / chance : 1.0 / (1.0 - chance);
        for (int band = 0; band < BANDS; band++) {
            double fraction = surfaces.scattered(material, band);
            energy[band] *= (diffuse ? fraction : 1.0 - fraction) * weight;
        }
        ledger.exchange(before, all());
        return diffuse;
    }

    /**
     * Scatters the packet in a direction that was drawn by Lambert's law.
     *
     * @param cosine cosine of the angle between the direction and the normal
     */
    void scatter(int material, double cosine) {
        if (!surfaces.isAngular(material)) {
            return;
        }
        double before = all();
        for (int band = 0; band < BANDS; band++) {
            energy[band] *= surfaces.scatteredTo(material, band, cosine);
        }
        ledger.exchange(before, all());
    }

    /**
     * Plays Russian roulette: ends faint rays by chance and strengthens the survivors, which leaves the mean unchanged.
     *
     * @return whether the ray survives
     */
    boolean playRoulette(RandomGenerator random) {
        double left = all();
        if (left >= faint) {
            return true;
        }
        if (left == 0.0 || random.nextDouble() >= SURVIVAL) {
            ledger.exchange(left, 0.0);
            return false;
        }
        for (int band = 0; band < BANDS; band++) {
            energy[band] /= SURVIVAL;
        }
        ledger.exchange(left, all());
        return true;
    }
}
