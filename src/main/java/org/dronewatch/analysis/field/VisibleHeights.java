package org.dronewatch.analysis.field;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/**
 * The lowest height above the ground to which each sensor has a clear line of sight, column by column. Above that
 * height, something may hide the drone again. Only the site matters, not the sensor's field of view and range.
 * Immutable.
 */
public final class VisibleHeights {
    private final FieldGrid grid;
    private final List<String> sensors;
    private final int columns;

    /** By sensor, then row and column, m above the ground; NaN where the sensor sees nothing up to the top. */
    private final float[][] heights;

    private VisibleHeights(FieldGrid grid, List<String> sensors, int columns, float[][] heights) {
        this.grid = grid;
        this.columns = columns;
        this.sensors = List.copyOf(sensors);
        this.heights = heights;
    }

    /**
     * Finds the heights for all enabled sensors of a scene, on the {@link Workers} of the calling thread; the result
     * does not depend on their number.
     *
     * @param grid the grid; the search ends at its greatest height
     */
    public static VisibleHeights of(SceneSettings settings, Stage stage, FieldGrid grid) {
        Map<String, Position> positions = new LinkedHashMap<>();
        settings.enabledSensors().forEach((id, sensor) -> positions.put(id, sensor.position()));
        return of(positions, stage, grid);
    }

    private static VisibleHeights of(Map<String, Position> positions, Stage stage, FieldGrid grid) {
        FieldColumns columns = FieldColumns.of(stage.world(), grid);
        List<Position> points = new ArrayList<>(positions.values());
        float[][] heights = new float[points.size()][grid.cells()];
        double top = grid.heights().get(grid.heights().size() - 1);
        Workers.forEach(grid.columns(), () -> new HorizonClimb(stage.world()), (climb, row) -> {
            for (int sensor = 0; sensor < heights.length; sensor++) {
                for (int column = 0; column < grid.columns(); column++) {
                    double ground = columns.ground(column, row);
                    double lowest = climb.lowest(points.get(sensor), grid.x(column), grid.y(row), ground, ground + top);
                    heights[sensor][grid.cell(column, row)] = (float) (lowest - ground);
                }
            }
        });
        return new VisibleHeights(grid, List.copyOf(positions.keySet()), columns.groundCount(), heights);
    }

    /** The grid. */
    public FieldGrid grid() {
        return grid;
    }

    /** The names of the sensors. */
    public List<String> sensors() {
        return sensors;
    }

    /**
     * The lowest height above the ground to which a sensor, given by its number, has a clear line of sight, m: too high
     * by at most 1 mm; NaN where it has none up to the greatest height of the grid, and where there is no ground.
     */
    public double height(int sensor, int column, int row) {
        return heights[sensor][grid.cell(column, row)];
    }

    /** The lowest of the heights of all sensors, m; NaN where none of them has a clear line of sight. */
    public double height(int column, int row) {
        double least = Double.NaN;
        for (int sensor = 0; sensor < heights.length; sensor++) {
            double its = height(sensor, column, row);
            least = its < least || Double.isNaN(least) ? its : least;
        }
        return least;
    }

    /** The number of columns with ground below them. */
    public int columns() {
        return columns;
    }

    /**
     * The number of columns in which a sensor, given by its number, has a clear line of sight to a given height, m, or
     * lower.
     */
    public int count(int sensor, double height) {
        int count = 0;
        for (float its : heights[sensor]) {
            count += its <= height ? 1 : 0;
        }
        return count;
    }

    /** The number of columns in which any sensor has a clear line of sight to a given height, m, or lower. */
    public int count(double height) {
        return grid.count((column, row) -> height(column, row) <= height);
    }
}
