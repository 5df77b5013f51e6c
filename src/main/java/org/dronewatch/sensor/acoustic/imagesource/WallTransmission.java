package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.ArcLine;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Transmission along straight lines and arcs: a sheet attenuates sound by its transmission loss, and a solid does so
 * only where the path enters it; opaque surfaces transmit nothing. For use by one thread.
 */
public final class WallTransmission {
    private static final int BANDS = OctaveBands.COUNT;

    private final Visibility visibility;
    private final BandSurfaces surfaces;
    private final CrossedFaces faces;
    private final WallPlanes planes;
    private final ArcLine line = new ArcLine();
    private final double[] passed = new double[BANDS];
    private boolean free;

    private final EnteredSolids within = new EnteredSolids();

    /** Transmission in a world, without a path yet. */
    public WallTransmission(World world, WallPlanes planes, BandSurfaces surfaces) {
        this.visibility = Visibility.ofClearPoints(world);
        this.planes = planes;
        this.surfaces = surfaces;
        this.faces = new CrossedFaces(world, surfaces);
    }

    /**
     * Follows the arc of sound between two points through everything that obstructs it.
     *
     * @param solids the solids within which the path begins
     * @param curvature curvature of the arc, 1/m, for sound that travels from the first point to the second or the
     *     reverse; positive if the arc bends up, 0 for a straight line
     * @return whether any of the sound arrives; {@link #isFree} and {@link #passed} then describe this path
     */
    public boolean trace(
            double fromX,
            double fromY,
            double fromZ,
            double toX,
            double toY,
            double toZ,
            EnteredSolids solids,
            double curvature) {
        begin(solids);
        return goOn(fromX, fromY, fromZ, toX, toY, toZ, curvature, WallPlanes.NONE, WallPlanes.NONE);
    }

    /**
     * Begins a path of several arcs.
     *
     * @param solids the solids within which it begins
     */
    void begin(EnteredSolids solids) {
        Arrays.fill(passed, 1.0);
        free = true;
        within.copy(solids);
    }

    /**
     * Follows the next arc of a path.
     *
     * @param curvature curvature of the arc, 1/m, for sound that travels from the first point to the second or the
     *     reverse; positive if the arc bends up, 0 for a straight line
     * @param one a wall that the arc does not cross, though rounding may make it seem so, or {@link WallPlanes#NONE}
     * @param other another such wall, or NONE
     * @return whether any of the sound gets to its end
     */
    boolean goOn(
            double fromX,
            double fromY,
            double fromZ,
            double toX,
            double toY,
            double toZ,
            double curvature,
            int one,
            int other) {
        if (curvature == 0.0) {
            return passesPiece(fromX, fromY, fromZ, toX, toY, toZ, one, other);
        }
        line.lay(fromX, fromY, fromZ, toX, toY, toZ, curvature, true);
        for (int piece = 0; piece < line.pieces(); piece++) {
            if (!passesPiece(
                    line.x(piece - 1),
                    line.y(piece - 1),
                    line.z(piece - 1),
                    line.x(piece),
                    line.y(piece),
                    line.z(piece),
                    one,
                    other)) {
                return false;
            }
        }
        return true;
    }

    /** Follows a straight piece of a path, and returns whether any of the sound gets to its end. */
    private boolean passesPiece(
            double fromX, double fromY, double fromZ, double toX, double toY, double toZ, int one, int other) {
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
            if (isOf(visibility.triangle(), one, other)) {
                found = visibility.findNext();
                continue;
            }
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

    private boolean isOf(int triangle, int one, int other) {
        int wall = planes.wallOf(triangle);
        return wall != WallPlanes.NONE && (wall == one || wall == other);
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
    public boolean isFree() {
        return free;
    }

    /** The solids within which the last path ends; not to be modified. */
    EnteredSolids within() {
        return within;
    }

    /** The fraction of a band's energy that was transmitted along the last path, 0 to 1. */
    public double passed(int band) {
        return passed[band];
    }
}
