package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.ArcLine;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Transmission along straight lines and arcs: a sheet attenuates by its transmission loss, a solid once, where the line
 * enters; opaque surfaces transmit nothing. One per thread.
 */
final class WallTransmission {
    private static final int BANDS = OctaveBands.COUNT;

    private final Visibility visibility;
    private final BandSurfaces surfaces;
    private final CrossedFaces faces;
    private final ArcLine line = new ArcLine();
    private final double[] passed = new double[BANDS];
    private boolean free;

    private final EnteredSolids within = new EnteredSolids();

    WallTransmission(World world, BandSurfaces surfaces) {
        this.visibility = Visibility.ofClearPoints(world);
        this.surfaces = surfaces;
        this.faces = new CrossedFaces(world, surfaces);
    }

    /**
     * Follows the arc of sound between two points through all that obstructs it.
     *
     * @param solids within which the path begins
     * @param curvature of sound on it, either way, 1/m; 0 for a straight line
     * @return whether any of the sound arrives; {@link #isFree} and {@link #passed} then describe this path
     */
    boolean trace(
            double fromX,
            double fromY,
            double fromZ,
            double toX,
            double toY,
            double toZ,
            EnteredSolids solids,
            double curvature) {
        Arrays.fill(passed, 1.0);
        free = true;
        within.copy(solids);
        if (curvature == 0.0) {
            return passesPiece(fromX, fromY, fromZ, toX, toY, toZ);
        }
        line.lay(fromX, fromY, fromZ, toX, toY, toZ, curvature, true);
        for (int piece = 0; piece < line.pieces(); piece++) {
            if (!passesPiece(
                    line.x(piece - 1),
                    line.y(piece - 1),
                    line.z(piece - 1),
                    line.x(piece),
                    line.y(piece),
                    line.z(piece))) {
                return false;
            }
        }
        return true;
    }

    /** Follows a straight piece of a path; whether any of the sound gets to its end. */
    private boolean passesPiece(double fromX, double fromY, double fromZ, double toX, double toY, double toZ) {
        double x = toX - fromX;
        double y = toY - fromY;
        double z = toZ - fromZ;
        if (visibility.isFreeAlong(fromX, fromY, fromZ, x, y, z, 1.0)) {
            return true;
        }
        free = false;
        if (!surfaces.anyTransmits()) {
            return false;
        }
        boolean found = visibility.findFirstAlong(fromX, fromY, fromZ, x, y, z, 1.0);
        while (found) {
            double along = visibility.distance();
            faces.find(
                    visibility.triangle(),
                    visibility.material(),
                    fromX + along * x,
                    fromY + along * y,
                    fromZ + along * z,
                    x,
                    y,
                    z);
            if (!passesFaces()) {
                return false;
            }
            found = visibility.findBeyond(along + faces.beyond());
        }
        return true;
    }

    private boolean passesFaces() {
        for (int i = 0; i < faces.count(); i++) {
            int material = faces.material(i);
            if (!faces.begins(i, within)) {
                continue;
            }
            if (!surfaces.transmits(material)) {
                return false;
            }
            for (int band = 0; band < BANDS; band++) {
                passed[band] *= surfaces.transmitted(material, band);
            }
        }
        faces.pass(within);
        return true;
    }

    /** Whether nothing obstructed the last path. */
    boolean isFree() {
        return free;
    }

    /** The fraction of a band's energy that passed along the last path, 0 to 1. */
    double passed(int band) {
        return passed[band];
    }
}
