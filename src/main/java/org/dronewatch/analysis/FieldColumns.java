package org.dronewatch.analysis;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.world.SurfaceColumn;
import org.dronewatch.world.World;

/**
 * The ground below the cells of a grid, and which cells are inside something solid. Heights count from the ground, not
 * from roofs: from the terrain, or, where there is none, from the lowest surface that faces up, such as a floor. A cell
 * is inside something solid where the nearest surface above it faces up: it is seen from its back.
 */
final class FieldColumns {
    private static final byte OPEN = 0;
    private static final byte INSIDE = 1;
    private static final byte NO_GROUND = 2;

    private final FieldGrid grid;
    private final double[] ground;
    private final byte[] kinds;

    /** The columns of a grid, on the threads of the {@link Workers} that call. */
    FieldColumns(World world, FieldGrid grid) {
        this.grid = grid;
        this.ground = new double[grid.cells()];
        this.kinds = new byte[grid.cells() * grid.heights().size()];
        Workers.forEach(grid.columns(), row -> {
            for (int column = 0; column < grid.columns(); column++) {
                set(column, row, SurfaceColumn.at(world, grid.x(column), grid.y(row)));
            }
        });
    }

    private void set(int column, int row, SurfaceColumn surfaces) {
        Optional<SurfaceColumn.Surface> lowest = surfaces.ground();
        int cell = row * grid.columns() + column;
        ground[cell] = lowest.map(SurfaceColumn.Surface::z).orElse(Double.NaN);
        for (int height = 0; height < grid.heights().size(); height++) {
            kinds[height * grid.cells() + cell] = lowest.isEmpty()
                    ? NO_GROUND
                    : isInside(
                                    surfaces.surfaces(),
                                    ground[cell] + grid.heights().get(height))
                            ? INSIDE
                            : OPEN;
        }
    }

    /** Surfaces are given from the highest to the lowest. */
    private static boolean isInside(List<SurfaceColumn.Surface> surfaces, double z) {
        boolean inside = false;
        for (SurfaceColumn.Surface surface : surfaces) {
            if (surface.z() <= z) {
                return inside;
            }
            inside = surface.facesUp();
        }
        return inside;
    }

    /** Whether there is ground below a column. */
    boolean hasGround(int column, int row) {
        return !Double.isNaN(ground[row * grid.columns() + column]);
    }

    /** The number of columns with ground below them. */
    int groundCount() {
        return (int) Arrays.stream(ground).filter(Double::isFinite).count();
    }

    /** The height of the ground, m; NaN where there is none. */
    double ground(int column, int row) {
        return ground[row * grid.columns() + column];
    }

    /** Whether a cell is inside something solid. */
    boolean isInside(int height, int column, int row) {
        return kinds[height * grid.cells() + row * grid.columns() + column] == INSIDE;
    }

    /** Whether a drone can be in a cell: there is ground below, and nothing solid around it. */
    boolean isOpen(int height, int column, int row) {
        return kinds[height * grid.cells() + row * grid.columns() + column] == OPEN;
    }

    /** The middle of a cell, m; over ground only. */
    Position middle(int height, int column, int row) {
        return new Position(
                grid.x(column),
                grid.y(row),
                ground(column, row) + grid.heights().get(height));
    }
}
