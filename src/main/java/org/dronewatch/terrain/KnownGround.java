package org.dronewatch.terrain;

import java.util.Arrays;
import org.dronewatch.geometry.Ints;
import org.dronewatch.geometry.TriangleMesh;

/**
 * The area in which the ground of a terrain is known. The ground in the holes of the terrain and beyond its rim is
 * unknown, and may hide anything. Immutable.
 */
public final class KnownGround {
    private final TerrainGround ground;
    /** Both ends of each edge that belongs to one triangle only: the rim, and the rims of holes. */
    private final double[] rim;

    /** The known ground of a terrain; triangles that share an edge must share its vertices. */
    public KnownGround(TerrainGround ground) {
        this.ground = ground;
        this.rim = rim(ground.mesh());
    }

    /**
     * The known ground of a terrain whose rim has been determined before.
     *
     * @param rim as {@link #rim()} returned it for the same terrain
     * @throws IllegalArgumentException if the rim is not a list of sides, each with the finite coordinates of both ends
     */
    public KnownGround(TerrainGround ground, double[] rim) {
        if (rim.length % 4 != 0 || !Arrays.stream(rim).allMatch(Double::isFinite)) {
            throw new IllegalArgumentException("rim of " + rim.length + " numbers is not a list of sides");
        }
        this.ground = ground;
        this.rim = rim.clone();
    }

    private static double[] rim(TriangleMesh mesh) {
        // Each side with its lower end first; those of two triangles are then next to each other.
        long[] sides = new long[3 * mesh.triangleCount()];
        for (int i = 0; i < mesh.triangleCount(); i++) {
            for (int k = 0; k < 3; k++) {
                long from = mesh.vertexIndex(i, k);
                long to = mesh.vertexIndex(i, (k + 1) % 3);
                sides[3 * i + k] = Math.min(from, to) << 32 | Math.max(from, to);
            }
        }
        Arrays.sort(sides);
        Ints ends = new Ints();
        for (int i = 0; i < sides.length; i++) {
            boolean isShared = i > 0 && sides[i - 1] == sides[i] || i + 1 < sides.length && sides[i + 1] == sides[i];
            if (!isShared) {
                ends.add((int) (sides[i] >>> 32));
                ends.add((int) sides[i]);
            }
        }
        double[] rim = new double[2 * ends.size()];
        for (int i = 0; i < ends.size(); i++) {
            rim[2 * i] = mesh.vertexCoordinate(ends.get(i), 0);
            rim[2 * i + 1] = mesh.vertexCoordinate(ends.get(i), 1);
        }
        return rim;
    }

    /** A copy of the sides of the rim, including those around holes: x and y of both ends of each side, m. */
    public double[] rim() {
        return rim.clone();
    }

    /** The terrain. */
    public TerrainGround ground() {
        return ground;
    }

    /** Whether there is ground at a point, m east and north. */
    public boolean contains(double x, double y) {
        return !Double.isNaN(ground.heightAt(x, y));
    }

    /** Whether there is ground everywhere below the line between two points, m east and north. */
    public boolean containsLine(double fromX, double fromY, double toX, double toY) {
        if (!contains(fromX, fromY) || !contains(toX, toY)) {
            return false;
        }
        double west = Math.min(fromX, toX);
        double east = Math.max(fromX, toX);
        double south = Math.min(fromY, toY);
        double north = Math.max(fromY, toY);
        double alongX = toX - fromX;
        double alongY = toY - fromY;
        for (int i = 0; i < rim.length; i += 4) {
            if (Math.max(rim[i], rim[i + 2]) >= west
                    && Math.min(rim[i], rim[i + 2]) <= east
                    && Math.max(rim[i + 1], rim[i + 3]) >= south
                    && Math.min(rim[i + 1], rim[i + 3]) <= north) {
                double first = side(rim[i] - fromX, rim[i + 1] - fromY, alongX, alongY);
                double second = side(rim[i + 2] - fromX, rim[i + 3] - fromY, alongX, alongY);
                double rimX = rim[i + 2] - rim[i];
                double rimY = rim[i + 3] - rim[i + 1];
                double start = side(fromX - rim[i], fromY - rim[i + 1], rimX, rimY);
                double end = side(toX - rim[i], toY - rim[i + 1], rimX, rimY);
                // A line through the end of a side crosses one of the two sides that meet there.
                if (first < 0.0 != second < 0.0 && start < 0.0 != end < 0.0) {
                    return false;
                }
            }
        }
        return true;
    }

    private static double side(double x, double y, double alongX, double alongY) {
        return x * alongY - y * alongX;
    }
}
