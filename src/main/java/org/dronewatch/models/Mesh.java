package org.dronewatch.models;

import java.util.List;

/**
 * A finished model: shared vertices, named parts and faces with materials. Coordinates are metres, y up, and already
 * rounded to the decimals the file carries, so that figures taken from the mesh hold for the file, too.
 *
 * @param name model name, also the stem of its files
 * @param decimals digits after the decimal point in the file
 * @param vertices vertices in file order
 * @param parts parts in file order
 */
public record Mesh(String name, int decimals, List<Point> vertices, List<Part> parts) {

    /** Copies the lists. */
    public Mesh {
        vertices = List.copyOf(vertices);
        parts = List.copyOf(parts);
    }

    /**
     * One object of the file; in the aircraft and the house, each part is a closed solid.
     *
     * @param name object name
     * @param faces faces in file order
     */
    public record Part(String name, List<Face> faces) {

        /** Copies the list. */
        public Part {
            faces = List.copyOf(faces);
        }
    }

    /**
     * A convex face.
     *
     * @param material surface colour
     * @param corners vertex indices from zero, counter-clockwise when seen from outside
     */
    public record Face(Material material, List<Integer> corners) {

        /** Copies the list. */
        public Face {
            corners = List.copyOf(corners);
        }

        int triangles() {
            return corners.size() - 2;
        }
    }

    /** Number of triangles after each face is split into a fan. */
    public int triangleCount() {
        return parts.stream()
                .flatMap(part -> part.faces().stream())
                .mapToInt(Face::triangles)
                .sum();
    }

    /** Vertex indices from zero, three per triangle, in file order. */
    public int[] triangles() {
        int[] indices = new int[3 * triangleCount()];
        int next = 0;
        for (Part part : parts) {
            for (Face face : part.faces()) {
                for (int i = 1; i <= face.triangles(); i++) {
                    indices[next++] = face.corners().get(0);
                    indices[next++] = face.corners().get(i);
                    indices[next++] = face.corners().get(i + 1);
                }
            }
        }
        return indices;
    }

    /** Materials in the order of their first use. */
    public List<Material> materials() {
        return parts.stream()
                .flatMap(part -> part.faces().stream())
                .map(Face::material)
                .distinct()
                .toList();
    }

    /** Smallest axis-aligned box around the vertices. */
    public Extent extent() {
        return Extent.of(vertices);
    }
}
