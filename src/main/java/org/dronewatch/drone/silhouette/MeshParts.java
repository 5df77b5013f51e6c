package org.dronewatch.drone.silhouette;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.TriangleMesh;

/**
 * The connected parts of a mesh, with the triangles and edges of each part. Vertices with equal coordinates count as
 * one; triangles with two equal corners are left out, since no ray hits them. Immutable.
 */
final class MeshParts {
    /** The coefficient of an edge that belongs to the outline in any case. */
    static final byte ALWAYS = Byte.MAX_VALUE;

    private final float[] points;
    private final int[] corners;
    private final int[] triangleEdges;
    private final byte[] directions;
    private final int[] edgeEnds;
    private final int[] firstTriangles;
    private final int[] firstEdges;

    /** A vertex, by its coordinates. */
    private record Vertex(float x, float y, float z) {}

    /** An edge between two vertices, the one with the lower number first. */
    private record Side(int from, int to) {}

    MeshParts(TriangleMesh mesh) {
        Map<Vertex, Integer> vertices = new HashMap<>();
        List<int[]> triangles = triangles(mesh, vertices);
        this.points = new float[3 * vertices.size()];
        vertices.forEach((vertex, number) -> {
            points[3 * number] = vertex.x();
            points[3 * number + 1] = vertex.y();
            points[3 * number + 2] = vertex.z();
        });
        int[] roots = roots(triangles, vertices.size());
        triangles.sort(Comparator.comparingInt(triangle -> roots[triangle[0]]));
        this.corners = new int[3 * triangles.size()];
        this.triangleEdges = new int[corners.length];
        this.directions = new byte[corners.length];
        Map<Side, Integer> sides = new HashMap<>();
        List<Side> inOrder = new ArrayList<>();
        List<Integer> triangleStarts = new ArrayList<>();
        List<Integer> edgeStarts = new ArrayList<>();
        int root = -1;
        for (int i = 0; i < triangles.size(); i++) {
            int[] triangle = triangles.get(i);
            if (roots[triangle[0]] != root) {
                root = roots[triangle[0]];
                triangleStarts.add(i);
                edgeStarts.add(inOrder.size());
            }
            for (int side = 0; side < 3; side++) {
                int from = triangle[side];
                int to = triangle[(side + 1) % 3];
                Side edge = new Side(Math.min(from, to), Math.max(from, to));
                corners[3 * i + side] = from;
                directions[3 * i + side] = (byte) (from < to ? 1 : -1);
                triangleEdges[3 * i + side] = sides.computeIfAbsent(edge, unseen -> {
                    inOrder.add(unseen);
                    return inOrder.size() - 1;
                });
            }
        }
        triangleStarts.add(triangles.size());
        edgeStarts.add(inOrder.size());
        this.firstTriangles =
                triangleStarts.stream().mapToInt(Integer::intValue).toArray();
        this.firstEdges = edgeStarts.stream().mapToInt(Integer::intValue).toArray();
        this.edgeEnds = inOrder.stream()
                .flatMapToInt(side -> java.util.stream.IntStream.of(side.from(), side.to()))
                .toArray();
    }

    private static List<int[]> triangles(TriangleMesh mesh, Map<Vertex, Integer> vertices) {
        List<int[]> triangles = new ArrayList<>();
        for (int i = 0; i < mesh.triangleCount(); i++) {
            int[] triangle = new int[3];
            for (int corner = 0; corner < 3; corner++) {
                // Adding 0 makes a negative zero positive.
                Vertex vertex = new Vertex(
                        mesh.coordinate(i, corner, 0) + 0.0F,
                        mesh.coordinate(i, corner, 1) + 0.0F,
                        mesh.coordinate(i, corner, 2) + 0.0F);
                triangle[corner] = vertices.computeIfAbsent(vertex, unseen -> vertices.size());
            }
            if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
                triangles.add(triangle);
            }
        }
        return triangles;
    }

    /** For each vertex, the representative of its part. */
    private static int[] roots(List<int[]> triangles, int vertices) {
        int[] parents = new int[vertices];
        for (int i = 0; i < vertices; i++) {
            parents[i] = i;
        }
        for (int[] triangle : triangles) {
            int root = root(parents, triangle[0]);
            parents[root(parents, triangle[1])] = root;
            parents[root(parents, triangle[2])] = root;
        }
        int[] roots = new int[vertices];
        for (int i = 0; i < vertices; i++) {
            roots[i] = root(parents, i);
        }
        return roots;
    }

    private static int root(int[] parents, int vertex) {
        int at = vertex;
        while (parents[at] != at) {
            parents[at] = parents[parents[at]];
            at = parents[at];
        }
        return at;
    }

    /** The coordinates x, y and z of each vertex, m; not copied. */
    float[] points() {
        return points;
    }

    int count() {
        return firstTriangles.length - 1;
    }

    int firstTriangle(int part) {
        return firstTriangles[part];
    }

    int firstEdge(int part) {
        return firstEdges[part];
    }

    int corner(int triangle, int number) {
        return corners[3 * triangle + number];
    }

    /** The edge from a corner of a triangle to the next. */
    int edge(int triangle, int side) {
        return triangleEdges[3 * triangle + side];
    }

    /** 1 where a triangle runs along an edge from its start to its end, otherwise -1. */
    int direction(int triangle, int side) {
        return directions[3 * triangle + side];
    }

    int edgeCount() {
        return edgeEnds.length / 2;
    }

    int edgeStart(int edge) {
        return edgeEnds[2 * edge];
    }

    int edgeEnd(int edge) {
        return edgeEnds[2 * edge + 1];
    }

    /** The coefficient of an edge with one more triangle; beyond a few triangles, their number does not matter. */
    static byte sum(byte coefficient, int added) {
        return coefficient == ALWAYS ? ALWAYS : (byte) Math.min(ALWAYS, coefficient + added);
    }
}
