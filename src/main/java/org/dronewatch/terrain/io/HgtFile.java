package org.dronewatch.terrain.io;

import java.io.IOException;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.setting.InputException;

/**
 * A tile of the Shuttle Radar Topography Mission: 1 by 1 degree, with 1201 or 3601 posts a side. Heights are in metres,
 * as signed 16-bit numbers, high byte first, row by row from the north-west corner; -32768 where there is no height.
 * The file name states where the south-west corner is (SRTM documentation, SRTM_Topo.txt, version 2.1, NASA/JPL 2015).
 */
final class HgtFile implements ElevationFile {
    private static final Pattern NAME = Pattern.compile("([ns])(\\d\\d)([ew])(\\d\\d\\d)[^/]*\\.hgt");
    private static final int VOID = -32768;
    private static final int THREE_SECONDS = 1201;
    private static final int ONE_SECOND = 3601;

    /** Bytes of the largest tile. */
    static final int MOST_BYTES = 2 * ONE_SECOND * ONE_SECOND;

    private final ElevationBytes bytes;
    private final int side;
    private final Lattice lattice;

    /**
     * A tile.
     *
     * @param tile name of the file, or of the packed file in it, in lower case and without directories
     */
    HgtFile(ElevationBytes bytes, String tile) {
        Matcher matcher = NAME.matcher(tile);
        if (!matcher.matches()) {
            throw new InputException(bytes.name()
                    + ": the name must begin with the tile's south-west corner, as in N43E007.hgt, since the file does not"
                    + " say where it is");
        }
        this.bytes = bytes;
        this.side = side(bytes);
        double south = Integer.parseInt(matcher.group(2)) * (matcher.group(1).equals("n") ? 1.0 : -1.0);
        double west = Integer.parseInt(matcher.group(4)) * (matcher.group(3).equals("e") ? 1.0 : -1.0);
        if (south < -90.0 || south > 89.0 || west < -180.0 || west > 179.0) {
            throw new InputException(bytes.name() + ": no tile on earth has this name");
        }
        double step = 1.0 / (side - 1);
        this.lattice = new Lattice(west, south + 1.0, step, 0.0, 0.0, -step);
    }

    private static int side(ElevationBytes bytes) {
        for (int side : new int[] {THREE_SECONDS, ONE_SECOND}) {
            if (bytes.size() == 2L * side * side) {
                return side;
            }
        }
        throw new InputException(bytes.name() + ": has " + bytes.size() + " bytes but must have "
                + 2 * THREE_SECONDS * THREE_SECONDS + " (posts 3 arc seconds apart) or " + MOST_BYTES
                + " (1 arc second)");
    }

    @Override
    public String name() {
        return bytes.name();
    }

    @Override
    public int columns() {
        return side;
    }

    @Override
    public int rows() {
        return side;
    }

    @Override
    public Lattice lattice() {
        return lattice;
    }

    @Override
    public Optional<CoordinateReferenceSystem> crs() {
        return Optional.of(CoordinateReferenceSystem.wgs84());
    }

    @Override
    public boolean statesUnit() {
        return true;
    }

    @Override
    public float[] heights(Window window) throws IOException {
        float[] heights = new float[(int) window.posts()];
        for (int row = 0; row < window.rows(); row++) {
            byte[] line = bytes.read(2L * ((long) (window.row() + row) * side + window.column()), 2 * window.columns());
            for (int column = 0; column < window.columns(); column++) {
                int height = line[2 * column] << 8 | line[2 * column + 1] & 0xFF;
                heights[row * window.columns() + column] = height == VOID ? Float.NaN : height;
            }
        }
        return heights;
    }

    @Override
    public boolean isSurfaceModel() {
        return true;
    }

    @Override
    public boolean statesNodata() {
        return true;
    }
}
