package org.dronewatch.geometry;

import java.util.List;

/**
 * A mesh of triangles that share vertices, each with a material. Coordinates are stored as floats, in metres: their
 * resolution is 0.06 mm at 1 km from the frame's origin and 8 mm at 100 km, so put the origin near the site. Immutable.
 */
public final class TriangleMesh {
    /**
     * The largest absolute value of a corner's coordinate, m: products of coordinates, as in distances and areas, must
     * not overflow in double precision.
     */
    public static final float MAX_COORDINATE = 1e30f;

    private final float[] vertices;
    private final int[] corners;
    private final int[] materials;
    private final int[] sourceNumbers;
    private final List<String> materialNames;

    /**
     * A mesh from flat arrays, which it copies.
     *
     * @param vertices x, y, z of each vertex in turn, m
     * @param corners three vertex numbers per triangle, from 0
     * @param materials one material number per triangle, an index into the names
     * @param sourceNumbers one number per triangle: its index in the source file, which also counts dropped triangles
     * @param materialNames the names of the materials
     * @throws IllegalArgumentException when the lengths of the arrays do not match, an index is out of range, or a
     *     coordinate is not finite or is beyond {@link #MAX_COORDINATE}
     */
    public TriangleMesh(
            float[] vertices, int[] corners, int[] materials, int[] sourceNumbers, List<String> materialNames) {
        if (vertices.length % 3 != 0 || corners.length % 3 != 0) {
            throw new IllegalArgumentException("mesh arrays of " + vertices.length + " coordinates and "
                    + corners.length + " corners must come in threes");
        }
        int triangles = corners.length / 3;
        if (materials.length != triangles || sourceNumbers.length != triangles) {
            throw new IllegalArgumentException("mesh of " + triangles + " triangles needs as many materials (has "
                    + materials.length + ") and source numbers (has " + sourceNumbers.length + ")");
        }
        this.vertices = vertices.clone();
        this.corners = corners.clone();
        this.materials = materials.clone();
        this.sourceNumbers = sourceNumbers.clone();
        this.materialNames = List.copyOf(materialNames);
        checkCoordinates();
        checkRange("corner", this.corners, vertices.length / 3);
        checkRange("material", this.materials, materialNames.size());
    }

    /**
     * A mesh of one unnamed material, whose triangles are numbered in the given order.
     *
     * @param vertices x, y, z of each vertex in turn, m
     * @param corners three vertex numbers per triangle, from 0
     */
    public static TriangleMesh of(float[] vertices, int[] corners) {
        int triangles = corners.length / 3;
        int[] numbers = new int[triangles];
        for (int i = 0; i < triangles; i++) {
            numbers[i] = i;
        }
        return new TriangleMesh(vertices, corners, new int[triangles], numbers, List.of("default"));
    }

    private void checkCoordinates() {
        for (int i = 0; i < vertices.length; i++) {
            if (!(Math.abs(vertices[i]) <= MAX_COORDINATE)) {
                throw new IllegalArgumentException("vertex " + i / 3 + " has the coordinate " + vertices[i]
                        + ", which must be finite and at most " + MAX_COORDINATE + " m");
            }
        }
    }

    private static void checkRange(String what, int[] indices, int limit) {
        for (int i = 0; i < indices.length; i++) {
            if (indices[i] < 0 || indices[i] >= limit) {
                throw new IllegalArgumentException(
                        what + " index " + indices[i] + " at entry " + i + " must be at least 0 and below " + limit);
            }
        }
    }

    /** A copy of the coordinates: x, y, z of each vertex in turn, m. */
    public float[] vertices() {
        return vertices.clone();
    }

    /** A copy of the corners: three vertex numbers per triangle. */
    public int[] corners() {
        return corners.clone();
    }

    /** A copy of the materials' numbers, one per triangle. */
    public int[] materials() {
        return materials.clone();
    }

    /** A copy of the numbers in the source file, one per triangle. */
    public int[] sourceNumbers() {
        return sourceNumbers.clone();
    }

    /** The number of triangles. */
    public int triangleCount() {
        return materials.length;
    }

    /** The number of vertices, used or not. */
    public int vertexCount() {
        return vertices.length / 3;
    }

    /** The greatest absolute value of a vertex's coordinates, m; 0 without vertices. */
    public double greatestCoordinate() {
        double greatest = 0.0;
        for (float coordinate : vertices) {
            greatest = Math.max(greatest, Math.abs(coordinate));
        }
        return greatest;
    }

    /**
     * One coordinate of one corner of a triangle, m.
     *
     * @param triangle the triangle's number
     * @param corner 0, 1 or 2
     * @param axis 0 for x, 1 for y, 2 for z
     */
    public float coordinate(int triangle, int corner, int axis) {
        return vertices[3 * corners[3 * triangle + corner] + axis];
    }

    /** The greatest distance of a triangle's corner from the origin, m; 0 without triangles. */
    public double radius() {
        double square = 0.0;
        for (int triangle = 0; triangle < triangleCount(); triangle++) {
            for (int corner = 0; corner < 3; corner++) {
                double x = coordinate(triangle, corner, 0);
                double y = coordinate(triangle, corner, 1);
                double z = coordinate(triangle, corner, 2);
                square = Math.max(square, x * x + y * y + z * z);
            }
        }
        return Math.sqrt(square);
    }

    /** The least coordinate of a triangle's corners on an axis, m; parameters as for {@link #coordinate}. */
    public float least(int triangle, int axis) {
        return Math.min(
                coordinate(triangle, 0, axis), Math.min(coordinate(triangle, 1, axis), coordinate(triangle, 2, axis)));
    }

    /** The greatest coordinate of a triangle's corners on an axis, m; parameters as for {@link #coordinate}. */
    public float greatest(int triangle, int axis) {
        return Math.max(
                coordinate(triangle, 0, axis), Math.max(coordinate(triangle, 1, axis), coordinate(triangle, 2, axis)));
    }

    /**
     * One coordinate of a vertex, m.
     *
     * @param vertex the vertex's number
     * @param axis 0 for x, 1 for y, 2 for z
     */
    public float vertexCoordinate(int vertex, int axis) {
        return vertices[3 * vertex + axis];
    }

    /** The vertex number of one corner of a triangle: corners with the same number are the same vertex. */
    public int vertexIndex(int triangle, int corner) {
        return corners[3 * triangle + corner];
    }

    /**
     * Writes a normal of a triangle, on the side from which its corners run counter-clockwise: the cross product of two
     * edges; its length is twice the area. Does not allocate.
     *
     * @param triangle the triangle's number
     * @param target receives x, y and z of the normal, m2
     */
    public void normal(int triangle, double[] target) {
        double ax = coordinate(triangle, 0, 0);
        double ay = coordinate(triangle, 0, 1);
        double az = coordinate(triangle, 0, 2);
        double bx = coordinate(triangle, 1, 0) - ax;
        double by = coordinate(triangle, 1, 1) - ay;
        double bz = coordinate(triangle, 1, 2) - az;
        double cx = coordinate(triangle, 2, 0) - ax;
        double cy = coordinate(triangle, 2, 1) - ay;
        double cz = coordinate(triangle, 2, 2) - az;
        target[0] = by * cz - bz * cy;
        target[1] = bz * cx - bx * cz;
        target[2] = bx * cy - by * cx;
    }

    /** One triangle as a value. */
    public Triangle triangle(int triangle) {
        return new Triangle(
                position(triangle, 0), position(triangle, 1), position(triangle, 2), triangle, materials[triangle]);
    }

    private Position position(int triangle, int corner) {
        return new Position(
                coordinate(triangle, corner, 0), coordinate(triangle, corner, 1), coordinate(triangle, corner, 2));
    }

    /** The material number of a triangle, an index into {@link #materialNames()}. */
    public int material(int triangle) {
        return materials[triangle];
    }

    /** The names of the materials, by number. */
    public List<String> materialNames() {
        return materialNames;
    }

    /** The triangle's number in the source file, which also counts dropped triangles. */
    public int sourceNumber(int triangle) {
        return sourceNumbers[triangle];
    }

    /**
     * The smallest box around all triangles; unused vertices do not count.
     *
     * @throws IllegalStateException if there is no triangle
     */
    public AABB bounds() {
        if (triangleCount() == 0) {
            throw new IllegalStateException("a mesh without triangles has no bounds");
        }
        float[] low = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY};
        float[] high = {Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};
        for (int corner : corners) {
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], vertices[3 * corner + axis]);
                high[axis] = Math.max(high[axis], vertices[3 * corner + axis]);
            }
        }
        return new AABB(low[0], low[1], low[2], high[0], high[1], high[2]);
    }
}
