package org.dronewatch.terrain;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.geo.MapExtent;
import org.dronewatch.geo.MapPoint;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.dronewatch.terrain.io.ElevationFile;
import org.dronewatch.terrain.io.ElevationFiles;
import org.dronewatch.terrain.io.Lattice;
import org.dronewatch.terrain.io.Window;

/**
 * Files that have one grid of posts in common, and the part of this grid that is near the origin. There is no gap
 * between files whose outermost posts are one step apart; where a file is missing, there is a hole.
 */
final class Mosaic {
    /** Posts that are read: at four bytes each they fill 100 MB. */
    static final int MOST_POSTS = 25_000_000;

    /** How far posts of two files may be apart, in steps of the grid. */
    private static final double SAME = 0.05;

    private static final int DIRECTIONS = 720;

    /** Degrees. */
    private static final double FULL_TURN = 360.0;

    private final List<ElevationFile> files;
    private final List<Window> windows = new ArrayList<>();
    private final CoordinateReferenceSystem crs;
    private final MapTransform map;
    private final Lattice lattice;
    private final Window window;

    /** Finds what the files contain near the origin. */
    Mosaic(List<ElevationFile> files, TerrainSettings settings, Origin origin) {
        this.files = files;
        this.crs = crs(files, settings.crs());
        this.map = new MapTransform(crs, origin);
        this.lattice = files.get(0).lattice();
        files.forEach(file -> windows.add(windowOf(file)));
        this.window = window(settings.radius(), origin);
    }

    private static CoordinateReferenceSystem crs(List<ElevationFile> files, Optional<String> given) {
        if (given.isPresent()) {
            return CoordinateReferenceSystem.of(given.get());
        }
        ElevationFile first = files.get(0);
        for (ElevationFile file : files) {
            CoordinateReferenceSystem own = file.crs()
                    .orElseThrow(() -> new InputException(file.name()
                            + ": does not state its coordinate reference system: set it, as in crs: EPSG:25832"));
            if (!own.equals(first.crs().orElseThrow())) {
                throw new InputException(file.name() + ": is in " + own + ", but " + first.name() + " is in "
                        + first.crs().orElseThrow() + ": gdalwarp -t_srs "
                        + first.crs().orElseThrow() + " converts it");
            }
        }
        return first.crs().orElseThrow();
    }

    /** Where a file is in the grid of the first one. */
    private Window windowOf(ElevationFile file) {
        Lattice own = file.lattice();
        // Tiles on either side of the date line lie side by side.
        double turn = crs.isGeographic() ? FULL_TURN * Math.rint((lattice.x() - own.x()) / FULL_TURN) : 0.0;
        double column = lattice.columnAt(own.x() + turn, own.y());
        double row = lattice.rowAt(own.x() + turn, own.y());
        double lastX = own.xAt(file.columns() - 1, file.rows() - 1) + turn;
        double lastY = own.yAt(file.columns() - 1, file.rows() - 1);
        double lastColumn = lattice.columnAt(lastX, lastY) - file.columns() + 1;
        double lastRow = lattice.rowAt(lastX, lastY) - file.rows() + 1;
        for (double offset : new double[] {
            column - Math.rint(column), row - Math.rint(row), lastColumn - Math.rint(column), lastRow - Math.rint(row)
        }) {
            if (!(Math.abs(offset) <= SAME)) {
                throw new InputException(String.format(
                        Locale.ROOT,
                        "%s: its posts, %s apart, are not those of the grid of %s, %s apart: gdalwarp -tr and -tap"
                                + " resample them to one grid",
                        file.name(),
                        steps(own),
                        files.get(0).name(),
                        steps(lattice)));
            }
        }
        if (!(Math.abs(column) < 1e8 && Math.abs(row) < 1e8)) {
            throw new InputException(
                    file.name() + ": lies too far from " + files.get(0).name());
        }
        return new Window((int) Math.rint(column), (int) Math.rint(row), file.columns(), file.rows());
    }

    private static String steps(Lattice lattice) {
        return String.format(
                Locale.ROOT,
                "%.9g x %.9g",
                Math.hypot(lattice.columnX(), lattice.columnY()),
                Math.hypot(lattice.rowX(), lattice.rowY()));
    }

    /** The columns and rows that a circle about the origin needs, as far as there are files. */
    private Window window(double radius, Origin origin) {
        double west = Double.POSITIVE_INFINITY;
        double north = Double.POSITIVE_INFINITY;
        double east = Double.NEGATIVE_INFINITY;
        double south = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < DIRECTIONS; i++) {
            double angle = 2.0 * Math.PI * i / DIRECTIONS;
            MapPoint point = map.onMap(new Position(radius * Math.sin(angle), radius * Math.cos(angle), 0.0));
            double mapX = crs.isGeographic() ? near(point.x()) : point.x();
            double column = lattice.columnAt(mapX, point.y());
            double row = lattice.rowAt(mapX, point.y());
            west = Math.min(west, column);
            east = Math.max(east, column);
            north = Math.min(north, row);
            south = Math.max(south, row);
        }
        Window needed = between(Math.floor(west), Math.floor(north), Math.ceil(east), Math.ceil(south));
        Window found = new Window(0, 0, 0, 0);
        for (Window file : windows) {
            Window part = file.and(needed);
            found = part.isEmpty() ? found : found.isEmpty() ? part : both(found, part);
        }
        if (found.columns() < 2 || found.rows() < 2) {
            throw new InputException(String.format(
                    Locale.ROOT,
                    "%s: no posts within %s m of the origin, at latitude %.5f and longitude %.5f: %s%s",
                    files.get(0).name(),
                    radius,
                    Math.toDegrees(origin.latitude()),
                    Math.toDegrees(origin.longitude()),
                    extent().inWords(map),
                    extent().suspicion(map, origin, radius, "of the origin")));
        }
        if (found.posts() > MOST_POSTS
                || found.columns() > Triangulation.MAX_SIDE
                || found.rows() > Triangulation.MAX_SIDE) {
            throw new InputException(String.format(
                    Locale.ROOT,
                    "%s: %,d x %,d posts within %s m of the origin; there must be at most %,d in all and %,d a side: choose a"
                            + " smaller radius, or gdalwarp -tr with larger steps",
                    files.get(0).name(),
                    found.columns(),
                    found.rows(),
                    radius,
                    MOST_POSTS,
                    Triangulation.MAX_SIDE));
        }
        return found;
    }

    /** A longitude, moved by whole turns to the range of the files. */
    private double near(double longitude) {
        double middle =
                lattice.xAt(0.5 * files.get(0).columns(), 0.5 * files.get(0).rows());
        return longitude + FULL_TURN * Math.rint((middle - longitude) / FULL_TURN);
    }

    /** The posts of all files, in the coordinates of the first one. */
    private MapExtent extent() {
        MapExtent.Collector extent = new MapExtent.Collector();
        for (Window file : windows) {
            int lastColumn = file.column() + file.columns() - 1;
            int lastRow = file.row() + file.rows() - 1;
            extent.add(lattice.xAt(file.column(), file.row()), lattice.yAt(file.column(), file.row()));
            extent.add(lattice.xAt(lastColumn, file.row()), lattice.yAt(lastColumn, file.row()));
            extent.add(lattice.xAt(file.column(), lastRow), lattice.yAt(file.column(), lastRow));
            extent.add(lattice.xAt(lastColumn, lastRow), lattice.yAt(lastColumn, lastRow));
        }
        return extent.extent();
    }

    private static Window between(double west, double north, double east, double south) {
        int column = clipped(west);
        int row = clipped(north);
        return new Window(column, row, clipped(east) - column + 1, clipped(south) - row + 1);
    }

    private static int clipped(double value) {
        return (int) Math.max(-5e8, Math.min(5e8, value));
    }

    private static Window both(Window one, Window other) {
        int column = Math.min(one.column(), other.column());
        int row = Math.min(one.row(), other.row());
        int east = Math.max(one.column() + one.columns(), other.column() + other.columns());
        int south = Math.max(one.row() + one.rows(), other.row() + other.rows());
        return new Window(column, row, east - column, south - row);
    }

    CoordinateReferenceSystem crs() {
        return crs;
    }

    MapTransform map() {
        return map;
    }

    Window window() {
        return window;
    }

    /** The posts of the window, counted from its first one. */
    Lattice lattice() {
        return lattice.from(window.column(), window.row());
    }

    /** How many posts all files have. */
    long posts() {
        return files.stream()
                .mapToLong(file -> (long) file.columns() * file.rows())
                .sum();
    }

    /** The files that have nothing near the origin. */
    List<ElevationFile> unused() {
        List<ElevationFile> far = new ArrayList<>(files);
        far.removeIf(file -> !windows.get(files.indexOf(file)).and(window).isEmpty());
        return far;
    }

    /** The heights of the window's posts, row by row, m; NaN where no file has one. */
    float[] heights() {
        float[] all = new float[(int) window.posts()];
        Arrays.fill(all, Float.NaN);
        for (int i = 0; i < files.size(); i++) {
            Window part = windows.get(i).and(window);
            if (!part.isEmpty()) {
                add(files.get(i), windows.get(i), part, all);
            }
        }
        return all;
    }

    private void add(ElevationFile file, Window where, Window part, float[] all) {
        float[] own;
        try {
            own = file.heights(part.moved(-where.column(), -where.row()));
        } catch (IOException e) {
            throw ElevationFiles.unreadable(file.name(), e);
        }
        for (int row = 0; row < part.rows(); row++) {
            int to = (part.row() + row - window.row()) * window.columns() + part.column() - window.column();
            int from = row * part.columns();
            for (int column = 0; column < part.columns(); column++) {
                if (Float.isNaN(all[to + column])) {
                    all[to + column] = own[from + column];
                }
            }
        }
    }
}
