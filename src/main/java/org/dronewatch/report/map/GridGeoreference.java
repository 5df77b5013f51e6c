package org.dronewatch.report.map;

import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;

/**
 * Where a square grid of the world frame lies in the UTM zone of the scene's origin, or in the polar grid beyond 84
 * degrees north and 80 degrees south: an affine transform, which turns the grid by the angle between true north and
 * grid north and scales it. It agrees with the exact transform at the centre; the corners of a grid of 10 km deviate by
 * less than 0.3 m, those of 100 km by less than half of the smallest possible cell.
 *
 * @param crs the system of the coordinates
 * @param matrix transforms column and row, counted from the north-western corner, to the coordinates: for x, the change
 *     per column, the change per row and the value at the corner, and then the same three for y, m
 */
@SuppressWarnings("ArrayRecordComponent")
record GridGeoreference(CoordinateReferenceSystem crs, double[] matrix) {
    private static final double NORTHERNMOST = 84.0;
    private static final double SOUTHERNMOST = -80.0;
    private static final int ZONES = 60;
    private static final double ZONE_WIDTH = 6.0;

    /** Copies the matrix. */
    GridGeoreference {
        matrix = matrix.clone();
    }

    /** A copy of the matrix. */
    @Override
    public double[] matrix() {
        return matrix.clone();
    }

    /**
     * The georeferencing of a grid.
     *
     * @param east east coordinate of the grid's centre, m
     * @param north north coordinate of the grid's centre, m
     * @param cell length of a cell's side, m
     * @param columns cells along a side
     * @throws org.dronewatch.setting.InputException where the system has no coordinates
     */
    static GridGeoreference of(Origin origin, double east, double north, double cell, int columns) {
        CoordinateReferenceSystem crs = crs(origin);
        MapTransform transform = new MapTransform(crs, origin);
        double half = 0.5 * columns * cell;
        // Differences across the whole grid, so that deviations are least at its edges.
        double[] west = at(transform, east - half, north);
        double[] opposite = at(transform, east + half, north);
        double[] top = at(transform, east, north + half);
        double[] bottom = at(transform, east, north - half);
        double[] middle = at(transform, east, north);
        double[] matrix = new double[6];
        for (int i = 0; i < 2; i++) {
            double column = (opposite[i] - west[i]) / columns;
            double row = (bottom[i] - top[i]) / columns;
            matrix[3 * i] = column;
            matrix[3 * i + 1] = row;
            matrix[3 * i + 2] = middle[i] - 0.5 * columns * (column + row);
        }
        return new GridGeoreference(crs, matrix);
    }

    /**
     * The map coordinates of a point of the plane z = 0. Far away, this plane is above the ground, but a plan does not
     * depend on heights.
     */
    private static double[] at(MapTransform transform, double x, double y) {
        var point = transform.onMap(new Position(x, y, 0.0));
        return new double[] {point.x(), point.y()};
    }

    private static CoordinateReferenceSystem crs(Origin origin) {
        double latitude = Math.toDegrees(origin.latitude());
        double longitude = Math.toDegrees(origin.longitude());
        if (latitude > NORTHERNMOST || latitude < SOUTHERNMOST) {
            return CoordinateReferenceSystem.of(latitude > 0.0 ? "EPSG:32661" : "EPSG:32761");
        }
        int zone = Math.floorMod((int) Math.floor((longitude + 180.0) / ZONE_WIDTH), ZONES) + 1;
        return CoordinateReferenceSystem.of("EPSG:" + ((latitude < 0.0 ? 32700 : 32600) + zone));
    }

    /** The code of the system in the EPSG register. */
    int code() {
        return Integer.parseInt(crs.name().substring("EPSG:".length()));
    }
}
