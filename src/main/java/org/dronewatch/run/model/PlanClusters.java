package org.dronewatch.run.model;

import java.util.Arrays;
import org.dronewatch.geometry.Ints;
import org.dronewatch.geometry.TriangleMesh;

/**
 * The separate parts of a model as a plan shows them, such as the houses of a town: triangles whose rectangles, rounded
 * to cells of a metre or more, touch or overlap belong together. Its memory does not depend on the model.
 */
final class PlanClusters {
    /** Number of cells along a side. */
    private static final int MOST_CELLS = 512;

    private static final double SMALLEST_CELL = 1.0;
    private static final int NONE = -1;

    private final TriangleMesh mesh;
    private final int first;
    private final int end;
    private final double west;
    private final double south;
    private final double cell;
    private final int columns;
    private final int rows;

    private PlanClusters(TriangleMesh mesh, int first, int end) {
        this.mesh = mesh;
        this.first = first;
        this.end = end;
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int triangle = first; triangle < end; triangle++) {
            for (int axis = 0; axis < 2; axis++) {
                low[axis] = Math.min(low[axis], mesh.least(triangle, axis));
                high[axis] = Math.max(high[axis], mesh.greatest(triangle, axis));
            }
        }
        this.west = low[0];
        this.south = low[1];
        double side = Math.max(high[0] - low[0], high[1] - low[1]);
        this.cell = Math.max(SMALLEST_CELL, side / (MOST_CELLS - 1));
        this.columns = (int) ((high[0] - low[0]) / cell) + 1;
        this.rows = (int) ((high[1] - low[1]) / cell) + 1;
    }

    /**
     * The lowest corner of each cluster of some triangles of a mesh.
     *
     * @param first index of the first of these triangles
     * @param end index after that of the last of these triangles
     * @return numbers of vertices of the mesh
     */
    static int[] lowestVertices(TriangleMesh mesh, int first, int end) {
        return first == end ? new int[0] : new PlanClusters(mesh, first, end).lowestVertices();
    }

    private int column(double x) {
        return (int) ((x - west) / cell);
    }

    private int row(double y) {
        return (int) ((y - south) / cell);
    }

    private int[] lowestVertices() {
        int[] clusters = clusters();
        int[] lowest = new int[Arrays.stream(clusters).max().orElse(NONE) + 1];
        Arrays.fill(lowest, NONE);
        for (int triangle = first; triangle < end; triangle++) {
            int cluster = clusters[row(mesh.least(triangle, 1)) * columns + column(mesh.least(triangle, 0))];
            for (int corner = 0; corner < 3; corner++) {
                int vertex = mesh.vertexIndex(triangle, corner);
                if (lowest[cluster] == NONE
                        || mesh.vertexCoordinate(vertex, 2) < mesh.vertexCoordinate(lowest[cluster], 2)) {
                    lowest[cluster] = vertex;
                }
            }
        }
        return lowest;
    }

    /** The number of the cluster of each cell. */
    private int[] clusters() {
        boolean[] covered = covered();
        int[] clusters = new int[columns * rows];
        Arrays.fill(clusters, NONE);
        int count = 0;
        Ints open = new Ints();
        for (int start = 0; start < clusters.length; start++) {
            if (covered[start] && clusters[start] == NONE) {
                open.clear();
                open.add(start);
                clusters[start] = count;
                for (int i = 0; i < open.size(); i++) {
                    spread(open.get(i), count, covered, clusters, open);
                }
                count++;
            }
        }
        return clusters;
    }

    private void spread(int from, int cluster, boolean[] covered, int[] clusters, Ints open) {
        for (int row = Math.max(0, from / columns - 1); row <= Math.min(rows - 1, from / columns + 1); row++) {
            for (int column = Math.max(0, from % columns - 1);
                    column <= Math.min(columns - 1, from % columns + 1);
                    column++) {
                int next = row * columns + column;
                if (covered[next] && clusters[next] == NONE) {
                    clusters[next] = cluster;
                    open.add(next);
                }
            }
        }
    }

    /** Which cells the rectangle of some triangle touches: sums over differences at the corners of the rectangles. */
    private boolean[] covered() {
        int wide = columns + 1;
        int[] sums = new int[wide * (rows + 1)];
        for (int triangle = first; triangle < end; triangle++) {
            int left = column(mesh.least(triangle, 0));
            int right = column(mesh.greatest(triangle, 0)) + 1;
            int bottom = row(mesh.least(triangle, 1));
            int top = row(mesh.greatest(triangle, 1)) + 1;
            sums[bottom * wide + left]++;
            sums[bottom * wide + right]--;
            sums[top * wide + left]--;
            sums[top * wide + right]++;
        }
        boolean[] covered = new boolean[columns * rows];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int at = row * wide + column;
                sums[at] += (row > 0 ? sums[at - wide] : 0)
                        + (column > 0 ? sums[at - 1] : 0)
                        - (row > 0 && column > 0 ? sums[at - wide - 1] : 0);
                covered[row * columns + column] = sums[at] > 0;
            }
        }
        return covered;
    }
}
