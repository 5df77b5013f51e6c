package org.dronewatch.analysis;

import java.util.Arrays;
import org.dronewatch.parallel.Workers;
import org.dronewatch.world.World;

/** The height of the highest surface in each cell, NaN where there is none. */
final class SurfaceHeights {
    final double[] height;

    SurfaceHeights(World world, CoverageGrid grid) {
        height = new double[grid.cells() * grid.cells()];
        Workers.forEach(grid.cells(), world::newGround, (ground, row) -> {
            for (int column = 0; column < grid.cells(); column++) {
                height[row * grid.cells() + column] =
                        ground.height(grid.x(column), grid.y(row)).orElse(Double.NaN);
            }
        });
    }

    /** The number of cells in which there is a surface. */
    int count() {
        return (int) Arrays.stream(height).filter(Double::isFinite).count();
    }
}
