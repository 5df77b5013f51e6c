package org.dronewatch.analysis;

import java.util.Arrays;
import java.util.OptionalDouble;
import org.dronewatch.parallel.Workers;
import org.dronewatch.world.World;

/** The height of the highest surface in each cell, NaN where there is none. */
final class SurfaceHeights {
    final double[] height;

    SurfaceHeights(World world, CoverageGrid grid) {
        height = new double[grid.cells() * grid.cells()];
        for (int row = 0; row < grid.cells(); row++) {
            Workers.checkInterrupted();
            for (int column = 0; column < grid.cells(); column++) {
                OptionalDouble surface = world.surfaceHeight(grid.x(column), grid.y(row));
                height[row * grid.cells() + column] = surface.orElse(Double.NaN);
            }
        }
    }

    /** In how many cells there is a surface. */
    int count() {
        return (int) Arrays.stream(height).filter(Double::isFinite).count();
    }
}
