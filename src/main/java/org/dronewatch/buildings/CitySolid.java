package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.Ints;
import org.maplibre.earcut4j.Earcut;

/**
 * The triangles of one solid of a city model, and its floor if the model has none.
 *
 * @param corners the numbers of the three vertices of each triangle
 * @param floor how many of the triangles were added as a floor
 * @param isClosed whether each side of a triangle is also a side of another one, in the opposite direction
 * @param isWhole whether the triangles cover all surfaces
 */
record CitySolid(int[] corners, int floor, boolean isClosed, boolean isWhole) {
    /** Triangles must cover a surface except for this fraction of its area. */
    private static final double PRECISION = 1e-3;

    /** How far the rim of a missing floor may be from level, m. */
    private static final double LEVEL = 0.5;

    /**
     * Cuts the surfaces of a solid into triangles, and closes it from below.
     *
     * @param surfaces each with its outline and openings, as numbers of vertices
     * @param vertices x, y, z of each in turn, m
     */
    static CitySolid of(List<List<int[]>> surfaces, double[] vertices) {
        Ints corners = new Ints();
        boolean isWhole = true;
        for (List<int[]> surface : surfaces) {
            isWhole &= cut(surface, vertices, corners);
        }
        int before = corners.size() / 3;
        Map<Long, Integer> open = open(corners.toArray());
        if (!open.isEmpty()) {
            isWhole &= addFloor(open, vertices, corners);
        }
        int[] all = corners.toArray();
        return new CitySolid(all, all.length / 3 - before, open(all).isEmpty(), isWhole);
    }

    /** Adds triangles, wound as the outline is; returns whether they cover the surface. */
    private static boolean cut(List<int[]> surface, double[] vertices, Ints target) {
        int[] outline = surface.get(0);
        if (outline.length < 3) {
            return true;
        }
        double[] normal = normal(outline, vertices);
        double twice = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        if (twice < 1e-6) {
            return true;
        }
        // Seen along the axis to which the surface is most nearly at right angles.
        int axis = 0;
        for (int i = 1; i < 3; i++) {
            axis = Math.abs(normal[i]) > Math.abs(normal[axis]) ? i : axis;
        }
        int first = (axis + 1) % 3;
        int second = (axis + 2) % 3;
        int count = surface.stream().mapToInt(ring -> ring.length).sum();
        double[] flat = new double[2 * count];
        int[] numbers = new int[count];
        int[] holes = new int[surface.size() - 1];
        int at = 0;
        double expected = 0.0;
        for (int ring = 0; ring < surface.size(); ring++) {
            if (ring > 0) {
                holes[ring - 1] = at;
            }
            double area = Math.abs(normal(surface.get(ring), vertices)[axis]);
            expected += ring == 0 ? area : -area;
            for (int vertex : surface.get(ring)) {
                flat[2 * at] = vertices[3 * vertex + first] - vertices[3 * outline[0] + first];
                flat[2 * at + 1] = vertices[3 * vertex + second] - vertices[3 * outline[0] + second];
                numbers[at++] = vertex;
            }
        }
        List<Integer> ears = Earcut.earcut(flat, holes, 2);
        double covered = 0.0;
        for (int i = 0; i < ears.size(); i += 3) {
            int a = ears.get(i);
            int b = ears.get(i + 1);
            int c = ears.get(i + 2);
            double area = (flat[2 * b] - flat[2 * a]) * (flat[2 * c + 1] - flat[2 * a + 1])
                    - (flat[2 * b + 1] - flat[2 * a + 1]) * (flat[2 * c] - flat[2 * a]);
            boolean isRight = area > 0.0 == normal[axis] > 0.0;
            target.add(numbers[a]);
            target.add(numbers[isRight ? b : c]);
            target.add(numbers[isRight ? c : b]);
            covered += Math.abs(area);
        }
        return Math.abs(covered - expected) <= PRECISION * expected;
    }

    /** The normal of a ring, as long as twice its area (Newell). */
    private static double[] normal(int[] ring, double[] vertices) {
        double[] normal = new double[3];
        int base = 3 * ring[0];
        for (int i = 0; i < ring.length; i++) {
            int a = 3 * ring[i];
            int b = 3 * ring[(i + 1) % ring.length];
            for (int axis = 0; axis < 3; axis++) {
                int u = (axis + 1) % 3;
                int v = (axis + 2) % 3;
                normal[axis] += (vertices[a + u] - vertices[base + u]) * (vertices[b + v] - vertices[base + v])
                        - (vertices[a + v] - vertices[base + v]) * (vertices[b + u] - vertices[base + u]);
            }
        }
        return normal;
    }

    private static long side(int from, int to) {
        return (long) from << 32 | to;
    }

    /** The sides that no other triangle has in the opposite direction, and how often each occurs. */
    static Map<Long, Integer> open(int[] corners) {
        Map<Long, Integer> sides = new LinkedHashMap<>();
        for (int i = 0; i < corners.length; i += 3) {
            for (int k = 0; k < 3; k++) {
                int from = corners[i + k];
                int to = corners[i + (k + 1) % 3];
                Long back = side(to, from);
                Integer others = sides.get(back);
                if (others == null) {
                    sides.merge(side(from, to), 1, Integer::sum);
                } else if (others == 1) {
                    sides.remove(back);
                } else {
                    sides.put(back, others - 1);
                }
            }
        }
        return sides;
    }

    /** Closes level openings, each with the openings that lie in it; returns whether what was added covers them. */
    private static boolean addFloor(Map<Long, Integer> open, double[] vertices, Ints target) {
        Map<Integer, Integer> back = new HashMap<>();
        for (Long side : open.keySet()) {
            // A floor has the sides the other way around.
            if (back.put(side.intValue(), (int) (side >> 32)) != null) {
                return true;
            }
        }
        List<int[]> rings = rings(back);
        List<int[]> outlines = new ArrayList<>();
        List<int[]> openings = new ArrayList<>();
        for (int[] ring : rings) {
            double lowest = Double.POSITIVE_INFINITY;
            double highest = Double.NEGATIVE_INFINITY;
            for (int vertex : ring) {
                lowest = Math.min(lowest, vertices[3 * vertex + 2]);
                highest = Math.max(highest, vertices[3 * vertex + 2]);
            }
            if (highest - lowest <= LEVEL) {
                // Seen from below, as a floor is, an outline runs counter-clockwise.
                (normal(ring, vertices)[2] < 0.0 ? outlines : openings).add(ring);
            }
        }
        boolean isWhole = true;
        for (int[] outline : outlines) {
            List<int[]> surface = new ArrayList<>();
            surface.add(outline);
            double[] flat = flat(outline, vertices);
            for (int[] opening : openings) {
                if (Rings.contains(flat, vertices[3 * opening[0]], vertices[3 * opening[0] + 1])) {
                    surface.add(opening);
                }
            }
            isWhole &= cut(surface, vertices, target);
        }
        return isWhole;
    }

    /** The corners of a ring as a plan shows them: x and y of each in turn. */
    static double[] flat(int[] ring, double[] vertices) {
        double[] flat = new double[2 * ring.length];
        for (int i = 0; i < ring.length; i++) {
            flat[2 * i] = vertices[3 * ring[i]];
            flat[2 * i + 1] = vertices[3 * ring[i] + 1];
        }
        return flat;
    }

    /** Sides chained into rings; those that do not close are left out. */
    static List<int[]> rings(Map<Integer, Integer> sides) {
        List<int[]> rings = new ArrayList<>();
        Map<Integer, Integer> left = new LinkedHashMap<>(sides);
        while (!left.isEmpty()) {
            int start = left.keySet().iterator().next();
            Ints ring = new Ints();
            Integer at = start;
            while (at != null && left.containsKey(at)) {
                ring.add(at);
                at = left.remove(at);
            }
            if (at != null && at == start) {
                rings.add(ring.toArray());
            }
        }
        return rings;
    }
}
