package org.dronewatch.models;

import java.util.ArrayList;
import java.util.List;

/**
 * The ground of the example site: a hill with a flat top at the plan origin, spurs, ravines and a river valley. Plan
 * coordinates are metres east and north of the origin, heights are metres; the model file has east as x, height as y
 * and south as z.
 */
public final class HillTerrain {

    /** Side of the square that the terrain covers, metres; the plan origin is its centre. */
    public static final double EDGE_METRES = 1500;

    /** Number of grid cells along each side; every cell is two triangles. */
    public static final int CELLS = 180;

    /** Height of the flat top at the plan origin, metres. */
    public static final double TOP_METRES = 132;

    /** Decimals of the model file; the heights are rounded to them. */
    static final int DECIMALS = 4;

    private static final double LEVEL_RADIUS = 24;
    private static final double BLEND_RADIUS = 75;
    private static final double DOME_METRES = 0.15;
    private static final int MARGIN_CELLS = 24;
    private static final ValueNoise TUSSOCKS = new ValueNoise(0x5eed04);

    private final HeightGrid grid;

    /** Computes the terrain, which takes about a second; it is the same every time. */
    public HillTerrain() {
        HeightGrid wide = new HeightGrid(CELLS + 1 + 2 * MARGIN_CELLS, EDGE_METRES / CELLS);
        Landform landform = new Landform();
        forEachCell(wide, (index, east, north) -> wide.set(index, landform.height(east, north)));
        new Erosion(wide).run(60, 0.004, 0.16);
        grid = wide.cropped(MARGIN_CELLS);
        forEachCell(grid, (index, east, north) -> grid.set(index, finish(grid.get(index), east, north)));
    }

    private interface CellAction {
        void accept(int index, double east, double north);
    }

    private static void forEachCell(HeightGrid grid, CellAction action) {
        for (int row = 0; row < grid.side(); row++) {
            for (int column = 0; column < grid.side(); column++) {
                action.accept(grid.index(column, row), grid.coordinate(column), grid.coordinate(row));
            }
        }
    }

    /** Levels the top, roughens the rest a little and rounds to what the file can carry. */
    private static double finish(double eroded, double east, double north) {
        double radius = StrictMath.hypot(east, north);
        double top = TOP_METRES - DOME_METRES * (radius / LEVEL_RADIUS) * (radius / LEVEL_RADIUS);
        double t = Math.min(Math.max((radius - LEVEL_RADIUS) / (BLEND_RADIUS - LEVEL_RADIUS), 0), 1);
        double share = t * t * (3 - 2 * t);
        double rough = 0.5 * TUSSOCKS.octaves(east / 22, north / 22, 2);
        double height = top + (eroded + rough - top) * share;
        return Math.round(height * 1e4) / 1e4;
    }

    /**
     * Height of the triangulated ground, metres, the same as in the model file except for rounding.
     *
     * @param x metres east of the plan origin
     * @param northY metres north of the plan origin
     * @throws IllegalArgumentException outside the square of {@link #EDGE_METRES}
     */
    public double groundHeight(double x, double northY) {
        double half = EDGE_METRES / 2;
        if (!(Math.abs(x) <= half && Math.abs(northY) <= half)) {
            throw new IllegalArgumentException("no terrain at (" + x + ", " + northY + ")");
        }
        double u = (x + half) / grid.spacing();
        double v = (northY + half) / grid.spacing();
        int column = Math.min((int) u, CELLS - 1);
        int row = Math.min((int) v, CELLS - 1);
        return inCell(column, row, u - column, v - row);
    }

    private double inCell(int column, int row, double u, double v) {
        double southWest = grid.get(column, row);
        double southEast = grid.get(column + 1, row);
        double northWest = grid.get(column, row + 1);
        double northEast = grid.get(column + 1, row + 1);
        if (splitsNorthEast(column, row)) {
            return u >= v
                    ? southWest + u * (southEast - southWest) + v * (northEast - southEast)
                    : southWest + v * (northWest - southWest) + u * (northEast - northWest);
        }
        return u + v <= 1
                ? southWest + u * (southEast - southWest) + v * (northWest - southWest)
                : northEast + (1 - u) * (northWest - northEast) + (1 - v) * (southEast - northEast);
    }

    /** Whether the diagonal runs from south-west to north-east: it follows the smaller fall, as crests do. */
    private boolean splitsNorthEast(int column, int row) {
        double rising = Math.abs(grid.get(column + 1, row + 1) - grid.get(column, row));
        double falling = Math.abs(grid.get(column + 1, row) - grid.get(column, row + 1));
        return rising <= falling;
    }

    /** Steepest slope of any triangle, degrees. */
    public double steepestDegrees() {
        return facets().stream()
                .mapToDouble(facet -> GroundCover.slopeDegrees(facet.corners()))
                .max()
                .orElseThrow();
    }

    /** The terrain as an open surface, facing up. */
    public Mesh mesh() {
        return new MeshBuilder("hill", DECIMALS)
                .addFacets("hill", sortedByMaterial(facets()))
                .build();
    }

    private static List<Solid.Facet> sortedByMaterial(List<Solid.Facet> facets) {
        List<Solid.Facet> sorted = new ArrayList<>();
        for (Material material : GroundCover.MATERIALS) {
            facets.stream().filter(facet -> facet.material().equals(material)).forEach(sorted::add);
        }
        return sorted;
    }

    private List<Solid.Facet> facets() {
        List<Solid.Facet> facets = new ArrayList<>();
        for (int row = 0; row < CELLS; row++) {
            for (int column = 0; column < CELLS; column++) {
                addCell(facets, column, row);
            }
        }
        return facets;
    }

    private void addCell(List<Solid.Facet> facets, int column, int row) {
        Point southWest = corner(column, row);
        Point southEast = corner(column + 1, row);
        Point northWest = corner(column, row + 1);
        Point northEast = corner(column + 1, row + 1);
        if (splitsNorthEast(column, row)) {
            facets.add(GroundCover.facet(southWest, southEast, northEast));
            facets.add(GroundCover.facet(southWest, northEast, northWest));
        } else {
            facets.add(GroundCover.facet(southWest, southEast, northWest));
            facets.add(GroundCover.facet(southEast, northEast, northWest));
        }
    }

    private Point corner(int column, int row) {
        return new Point(grid.coordinate(column), grid.get(column, row), -grid.coordinate(row));
    }
}
