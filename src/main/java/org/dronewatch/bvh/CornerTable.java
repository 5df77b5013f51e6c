package org.dronewatch.bvh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The corners of a mesh; a corner that several triangles share is listed only once. Immutable. */
final class CornerTable {
    private final double[] coordinates;
    private final int[] ofTriangles;

    /**
     * The corners of triangles.
     *
     * @param corners nine coordinates per triangle
     */
    CornerTable(float[] corners) {
        this.ofTriangles = new int[corners.length / 3];
        List<List<Float>> found = new ArrayList<>();
        for (int i = 0; i < ofTriangles.length; i++) {
            List<Float> corner = List.of(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
            if (!found.contains(corner)) {
                found.add(corner);
            }
            ofTriangles[i] = found.indexOf(corner);
        }
        this.coordinates = found.stream()
                .flatMap(List::stream)
                .mapToDouble(Float::doubleValue)
                .toArray();
    }

    /** Number of corners. */
    int count() {
        return coordinates.length / 3;
    }

    /** The three coordinates of a corner. */
    double[] corner(int number) {
        return Arrays.copyOfRange(coordinates, 3 * number, 3 * number + 3);
    }

    /** Three corners for each triangle: their indices times a stride. */
    int[] triangles(int stride) {
        return Arrays.stream(ofTriangles).map(corner -> stride * corner).toArray();
    }

    /** Writes all corners into one lane of vectors, three vectors each: their coordinates in the order for an axis. */
    void fill(double[] target, int lane, int lanes, int kz) {
        int kx = kz == 2 ? 0 : kz + 1;
        int ky = kx == 2 ? 0 : kx + 1;
        int at = lane;
        for (int i = 0; i < coordinates.length; i += 3) {
            target[at] = coordinates[i + kx];
            target[at + lanes] = coordinates[i + ky];
            target[at + 2 * lanes] = coordinates[i + kz];
            at += 3 * lanes;
        }
    }
}
