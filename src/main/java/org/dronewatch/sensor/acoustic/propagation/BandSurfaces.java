package org.dronewatch.sensor.acoustic.propagation;

import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.AngularAbsorption;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;

/**
 * The surface properties that the energy model uses: fractions by material and band, in flat arrays. Materials are
 * numbered as in the world, bands from 0 for 63 Hz to 7 for 8 kHz.
 */
public final class BandSurfaces {
    private static final int BANDS = OctaveBands.COUNT;

    private final double[] reflected;
    private final double[] transmitted;
    private final double[] scattered;
    private final boolean[] transmits;
    private final boolean[] scatters;
    private final boolean[] mirrors;
    private final boolean[] evenlyScattering;
    private final boolean[] sheet;
    private final boolean anyTransmits;
    private final boolean anyScatters;

    /** The absorption by angle of each material; null if it is the same at all angles. */
    private final AngularAbsorption[] angular;

    /** The surfaces of a world, indexed by material. */
    public BandSurfaces(List<SurfaceMaterial> surfaces) {
        int count = surfaces.size();
        this.reflected = new double[BANDS * count];
        this.transmitted = new double[BANDS * count];
        this.scattered = new double[BANDS * count];
        this.transmits = new boolean[count];
        this.scatters = new boolean[count];
        this.mirrors = new boolean[count];
        this.evenlyScattering = new boolean[count];
        this.sheet = new boolean[count];
        this.angular = new AngularAbsorption[count];
        for (int i = 0; i < count; i++) {
            SurfaceMaterial surface = surfaces.get(i);
            transmits[i] = !surface.isOpaque();
            sheet[i] = surface.wall() == Wall.SHEET;
            angular[i] = surface.angular().orElse(null);
            for (int band = 0; band < BANDS; band++) {
                reflected[BANDS * i + band] = surface.reflected(band);
                transmitted[BANDS * i + band] = surface.transmitted(band);
                scattered[BANDS * i + band] = surface.scattering().get(band);
                scatters[i] |= scattered(i, band) > 0.0;
                mirrors[i] |= mirrored(i, band) > 0.0;
            }
            evenlyScattering[i] = surface.scattering().stream().distinct().count() == 1L;
        }
        this.anyTransmits = surfaces.stream().anyMatch(surface -> !surface.isOpaque());
        this.anyScatters = IntStream.range(0, count).anyMatch(this::scatters);
    }

    /** The fraction that is reflected in a diffuse field. */
    public double reflected(int material, int band) {
        return reflected[BANDS * material + band];
    }

    /**
     * The fraction that is reflected.
     *
     * @param cosine cosine of the angle of incidence, from the normal, 0 to 1
     */
    public double reflected(int material, int band, double cosine) {
        return angular[material] == null ? reflected(material, band) : 1.0 - angular[material].at(band, cosine);
    }

    /**
     * Multiplies the energies in all bands by the fractions that a surface reflects.
     *
     * @param cosine cosine of the angle of incidence, from the normal, 0 to 1
     * @param energies the energy in each band
     * @param absorbed for each band, the sum of what surfaces have absorbed so far, to which this is added
     */
    public void reflect(int material, double cosine, double[] energies, double[] absorbed) {
        if (isAngular(material)) {
            for (int band = 0; band < BANDS; band++) {
                BandFactors.replace(energies, band, energies[band] * reflected(material, band, cosine), absorbed);
            }
            return;
        }
        BandFactors.multiply(energies, reflected, BANDS * material, absorbed);
    }

    /** Whether absorption depends on the angle. */
    public boolean isAngular(int material) {
        return angular[material] != null;
    }

    /**
     * Factor by which the energy scattered in one direction differs from Lambert's law: a surface that reflects little
     * sound from a direction scatters little into that direction. The factor is the fraction reflected at this angle
     * divided by the fraction reflected in a diffuse field, so that reciprocity (Helmholtz) holds and energy is
     * conserved; 1 where absorption does not depend on the angle.
     *
     * @param cosine cosine of the angle between the direction and the normal, 0 to 1
     */
    public double scatteredTo(int material, int band, double cosine) {
        if (angular[material] == null) {
            return 1.0;
        }
        double mean = reflected(material, band);
        return mean > 0.0 ? reflected(material, band, cosine) / mean : 0.0;
    }

    /** The fraction transmitted on entry; sound leaves a solid without further loss. */
    public double transmitted(int material, int band) {
        return transmitted[BANDS * material + band];
    }

    /**
     * The fraction that is reflected specularly.
     *
     * @param cosine cosine of the angle of incidence, from the normal, 0 to 1
     */
    public double mirrored(int material, int band, double cosine) {
        return reflected(material, band, cosine) * (1.0 - scattered(material, band));
    }

    /** The fraction that is reflected specularly in a diffuse field. */
    public double mirrored(int material, int band) {
        return reflected(material, band) * (1.0 - scattered(material, band));
    }

    /** Whether anything is reflected specularly. */
    public boolean mirrors(int material) {
        return mirrors[material];
    }

    /** Whether anything is scattered. */
    public boolean scatters(int material) {
        return scatters[material];
    }

    /** Whether any material scatters sound. */
    public boolean anyScatters() {
        return anyScatters;
    }

    /** Whether the same fraction is scattered in all bands. */
    public boolean isEvenlyScattering(int material) {
        return evenlyScattering[material];
    }

    /** The fraction of the reflected energy that is scattered. */
    public double scattered(int material, int band) {
        return scattered[BANDS * material + band];
    }

    /**
     * The scattered fraction of the total energy reflected in all bands, given the reflected energy in each band.
     */
    public double chanceOfScattering(int material, double[] energies) {
        double all = 0.0;
        double diffuse = 0.0;
        for (int band = 0; band < BANDS; band++) {
            all += energies[band];
            diffuse += energies[band] * scattered(material, band);
        }
        return all > 0.0 ? diffuse / all : 0.0;
    }

    /** Whether a material transmits sound. */
    public boolean transmits(int material) {
        return transmits[material];
    }

    /** Whether any material transmits sound. */
    public boolean anyTransmits() {
        return anyTransmits;
    }

    /** Whether a material represents a sheet: a wall that is one surface, not a front and a back. */
    public boolean isSheet(int material) {
        return sheet[material];
    }
}
