package org.dronewatch.terrain;

import java.util.function.IntConsumer;
import org.dronewatch.geometry.TriangleMesh;

/**
 * Finds the triangles of a terrain below a point or an area. A terrain has one height at each point: its triangles do
 * not overlap in plan view. Immutable.
 */
public final class TerrainGround {
    /**
     * How far outside a triangle a point may lie and still belong to it, since corners are floats, as a fraction
     * of the triangle.
     */
    private static final double ROUNDING = 1e-5;

    private final TriangleMesh mesh;
    private final double west;
    private final double south;
    private final double step;
    private final int columns;
    private final int rows;
    /** Where the triangles of each cell start in the list, and one more entry. */
    private final int[] starts;

    private final int[] triangles;

    /**
     * Sorts the triangles of a terrain into square cells.
     *
     * @param mesh mesh of the terrain
     */
    public TerrainGround(TriangleMesh mesh) {
        this.mesh = mesh;
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int i = 0; i < mesh.triangleCount(); i++) {
            for (int axis = 0; axis < 2; axis++) {
                low[axis] = Math.min(low[axis], mesh.least(i, axis));
                high[axis] = Math.max(high[axis], mesh.greatest(i, axis));
            }
        }
        boolean isEmpty = mesh.triangleCount() == 0;
        west = isEmpty ? 0.0 : low[0];
        south = isEmpty ? 0.0 : low[1];
        double width = isEmpty ? 0.0 : high[0] - west;
        double height = isEmpty ? 0.0 : high[1] - south;
        // About two triangles a cell.
        step = Math.max(Math.sqrt(2.0 * width * height / Math.max(1, mesh.triangleCount())), 1e-3);
        columns = (int) (width / step) + 1;
        rows = (int) (height / step) + 1;
        starts = new int[columns * rows + 1];
        for (int i = 0; i < mesh.triangleCount(); i++) {
            forCells(
                    mesh.least(i, 0),
                    mesh.greatest(i, 0),
                    mesh.least(i, 1),
                    mesh.greatest(i, 1),
                    cell -> starts[cell + 1]++);
        }
        for (int cell = 0; cell < columns * rows; cell++) {
            starts[cell + 1] += starts[cell];
        }
        triangles = new int[starts[columns * rows]];
        int[] next = starts.clone();
        for (int i = 0; i < mesh.triangleCount(); i++) {
            int triangle = i;
            forCells(
                    mesh.least(i, 0),
                    mesh.greatest(i, 0),
                    mesh.least(i, 1),
                    mesh.greatest(i, 1),
                    cell -> triangles[next[cell]++] = triangle);
        }
    }

    private void forCells(double fromX, double toX, double fromY, double toY, IntConsumer target) {
        int right = column(toX);
        int top = row(toY);
        for (int row = row(fromY); row <= top; row++) {
            for (int column = column(fromX); column <= right; column++) {
                target.accept(row * columns + column);
            }
        }
    }

    private int column(double x) {
        return (int) Math.max(0.0, Math.min(columns - 1.0, (x - west) / step));
    }

    private int row(double y) {
        return (int) Math.max(0.0, Math.min(rows - 1.0, (y - south) / step));
    }

    /** The terrain. */
    public TriangleMesh mesh() {
        return mesh;
    }

    /**
     * The height of the ground at a point.
     *
     * @param x east, m
     * @param y north, m
     * @return z of the ground, m; NaN where there is none, in a hole or beyond the rim
     */
    public double heightAt(double x, double y) {
        if (!(x >= west && y >= south && x <= west + columns * step && y <= south + rows * step)) {
            return Double.NaN;
        }
        int cell = row(y) * columns + column(x);
        for (int i = starts[cell]; i < starts[cell + 1]; i++) {
            double height = heightIn(triangles[i], x, y);
            if (!Double.isNaN(height)) {
                return height;
            }
        }
        return Double.NaN;
    }

    private double heightIn(int triangle, double x, double y) {
        double ax = mesh.coordinate(triangle, 0, 0);
        double ay = mesh.coordinate(triangle, 0, 1);
        double bx = mesh.coordinate(triangle, 1, 0) - ax;
        double by = mesh.coordinate(triangle, 1, 1) - ay;
        double cx = mesh.coordinate(triangle, 2, 0) - ax;
        double cy = mesh.coordinate(triangle, 2, 1) - ay;
        double area = bx * cy - by * cx;
        double second = ((x - ax) * cy - (y - ay) * cx) / area;
        double third = ((y - ay) * bx - (x - ax) * by) / area;
        if (!(second >= -ROUNDING && third >= -ROUNDING && second + third <= 1.0 + ROUNDING)) {
            return Double.NaN;
        }
        double az = mesh.coordinate(triangle, 0, 2);
        return az + second * (mesh.coordinate(triangle, 1, 2) - az) + third * (mesh.coordinate(triangle, 2, 2) - az);
    }

    /**
     * Lists the triangles near a rectangle in plan view; some may lie outside the rectangle, and some may be listed
     * more than once.
     *
     * @param fromX western limit of the rectangle, m
     * @param toX eastern limit of the rectangle, m
     * @param fromY southern limit of the rectangle, m
     * @param toY northern limit of the rectangle, m
     * @param target receives the number of each triangle
     */
    public void trianglesNear(double fromX, double toX, double fromY, double toY, IntConsumer target) {
        if (toX < west || toY < south || fromX > west + columns * step || fromY > south + rows * step) {
            return;
        }
        forCells(fromX, toX, fromY, toY, cell -> {
            for (int i = starts[cell]; i < starts[cell + 1]; i++) {
                target.accept(triangles[i]);
            }
        });
    }
}
