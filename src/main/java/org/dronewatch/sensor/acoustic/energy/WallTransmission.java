package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Transmission along straight lines: a sheet attenuates by its transmission loss, a solid once, where the line enters;
 * opaque surfaces transmit nothing. One per thread.
 */
final class WallTransmission {
    private static final int BANDS = OctaveBands.COUNT;

    private final TriangleMesh mesh;
    private final Visibility visibility;
    private final BandSurfaces surfaces;
    private final double[] passed = new double[BANDS];
    private boolean free;

    WallTransmission(World world, BandSurfaces surfaces) {
        this.mesh = world.mesh();
        this.visibility = Visibility.ofClearPoints(world);
        this.surfaces = surfaces;
    }

    /**
     * Follows the straight line from one point to another through everything that obstructs it.
     *
     * @param medium number of the material in which the path begins, or {@link AcousticRay#AIR}
     * @return whether any of the sound arrives; {@link #isFree} and {@link #passed} then describe this line
     */
    boolean trace(double fromX, double fromY, double fromZ, double toX, double toY, double toZ, int medium) {
        double x = toX - fromX;
        double y = toY - fromY;
        double z = toZ - fromZ;
        Arrays.fill(passed, 1.0);
        free = visibility.isFreeAlong(fromX, fromY, fromZ, x, y, z, 1.0);
        if (free) {
            return true;
        }
        if (!surfaces.anyTransmits()) {
            return false;
        }
        int within = medium;
        boolean found = visibility.findFirstAlong(fromX, fromY, fromZ, x, y, z, 1.0);
        while (found) {
            int material = mesh.material(visibility.triangle());
            if (!surfaces.transmits(material)) {
                return false;
            }
            if (within == material) {
                within = AcousticRay.AIR;
            } else {
                for (int band = 0; band < BANDS; band++) {
                    passed[band] *= surfaces.transmitted(material, band);
                }
                within = surfaces.isSheet(material) ? within : material;
            }
            found = visibility.findNext();
        }
        return true;
    }

    /** Whether nothing obstructed the last line. */
    boolean isFree() {
        return free;
    }

    /** The fraction of a band's energy that passed along the last line, 0 to 1. */
    double passed(int band) {
        return passed[band];
    }
}
