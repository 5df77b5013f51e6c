package org.dronewatch.sensor.acoustic.energy;

import java.util.List;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.SurfaceMaterial;
import org.dronewatch.sound.SurfaceMaterial.Wall;

/** The surface properties that the energy model uses: fractions by material and band, in flat arrays. */
final class BandSurfaces {
    private static final int BANDS = OctaveBands.COUNT;

    private final double[] reflected;
    private final double[] transmitted;
    private final double[] scattered;
    private final boolean[] transmits;
    private final boolean[] sheet;
    private final boolean anyTransmits;

    BandSurfaces(List<SurfaceMaterial> surfaces) {
        int count = surfaces.size();
        this.reflected = new double[BANDS * count];
        this.transmitted = new double[BANDS * count];
        this.scattered = new double[BANDS * count];
        this.transmits = new boolean[count];
        this.sheet = new boolean[count];
        for (int i = 0; i < count; i++) {
            SurfaceMaterial surface = surfaces.get(i);
            transmits[i] = !surface.isOpaque();
            sheet[i] = surface.wall() == Wall.SHEET;
            for (int band = 0; band < BANDS; band++) {
                reflected[BANDS * i + band] = surface.reflected(band);
                transmitted[BANDS * i + band] = surface.transmitted(band);
                scattered[BANDS * i + band] = surface.scattering().get(band);
            }
        }
        this.anyTransmits = surfaces.stream().anyMatch(surface -> !surface.isOpaque());
    }

    double reflected(int material, int band) {
        return reflected[BANDS * material + band];
    }

    /** The fraction transmitted on entry; what is inside a solid leaves it without further loss. */
    double transmitted(int material, int band) {
        return transmitted[BANDS * material + band];
    }

    /** The fraction that is reflected specularly. */
    double mirrored(int material, int band) {
        return reflected(material, band) * (1.0 - scattered(material, band));
    }

    /** Whether anything is reflected specularly. */
    boolean mirrors(int material) {
        for (int band = 0; band < BANDS; band++) {
            if (mirrored(material, band) > 0.0) {
                return true;
            }
        }
        return false;
    }

    /** Whether anything is scattered. */
    boolean scatters(int material) {
        for (int band = 0; band < BANDS; band++) {
            if (scattered(material, band) > 0.0) {
                return true;
            }
        }
        return false;
    }

    double scattered(int material, int band) {
        return scattered[BANDS * material + band];
    }

    boolean transmits(int material) {
        return transmits[material];
    }

    /** Whether there is any material that lets sound through. */
    boolean anyTransmits() {
        return anyTransmits;
    }

    boolean isSheet(int material) {
        return sheet[material];
    }
}
