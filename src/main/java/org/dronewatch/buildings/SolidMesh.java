package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.Floats;
import org.dronewatch.geometry.Ints;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;

/** Collects the triangles of closed solids, which face outwards. */
final class SolidMesh {
    /** Corners nearer to each other than this count as one: a tenth of a millimetre, m. */
    private static final double WELD = 1e-4;

    private final Floats vertices = new Floats();
    private final Ints corners = new Ints();
    private final Ints materials = new Ints();
    private final Map<String, Integer> materialNumbers = new LinkedHashMap<>();
    private final Map<Place, Integer> welded = new HashMap<>();
    private Upright upright;
    private int material;

    private record Place(long x, long y, long height) {}

    /** Begins the next solid. */
    void begin(Upright where, String ofMaterial) {
        upright = where;
        welded.clear();
        material = materialNumbers.computeIfAbsent(ofMaterial, name -> materialNumbers.size());
    }

    int triangles() {
        return materials.size();
    }

    private int vertex(double x, double y, double height) {
        return welded.computeIfAbsent(
                new Place(Math.round(x / WELD), Math.round(y / WELD), Math.round(height / WELD)), place -> {
                    Position position = upright.position(x, y, height);
                    vertices.add((float) position.x());
                    vertices.add((float) position.y());
                    vertices.add((float) position.z());
                    return vertices.size() / 3 - 1;
                });
    }

    /** Adds the triangle of three corners, unless it has no area. */
    private void triangle(int a, int b, int c) {
        if (a != b && b != c && c != a) {
            corners.add(a);
            corners.add(b);
            corners.add(c);
            materials.add(material);
        }
    }

    /**
     * A solid with upright walls.
     *
     * @param footprint relative to the place of {@link #begin}
     * @param cut its triangles
     * @param bottom height of the floor, m
     * @param top height of the flat roof, m
     */
    void prism(Footprint footprint, Footprint.Cut cut, double bottom, double top) {
        lid(footprint, cut, bottom, false);
        lid(footprint, cut, top, true);
        for (double[] ring : footprint.rings()) {
            int last = ring.length - 2;
            for (int i = 0; i < ring.length; i += 2) {
                int a = vertex(ring[last], ring[last + 1], bottom);
                int b = vertex(ring[i], ring[i + 1], bottom);
                int c = vertex(ring[i], ring[i + 1], top);
                int d = vertex(ring[last], ring[last + 1], top);
                triangle(a, b, c);
                triangle(a, c, d);
                last = i;
            }
        }
    }

    private void lid(Footprint footprint, Footprint.Cut cut, double height, boolean isUp) {
        double[] all =
                footprint.rings().stream().flatMapToDouble(Arrays::stream).toArray();
        int[] found = cut.corners();
        int[] three = new int[3];
        for (int i = 0; i < found.length; i += 3) {
            for (int k = 0; k < 3; k++) {
                three[k] = vertex(all[2 * found[i + k]], all[2 * found[i + k] + 1], height);
            }
            triangle(three[0], isUp ? three[1] : three[2], isUp ? three[2] : three[1]);
        }
    }

    /**
     * A solid with upright walls under a roof with slopes.
     *
     * @param footprint without courtyards, relative to the place of {@link #begin}
     * @param cut its triangles
     * @param bottom height of the floor, m
     * @param eaves height from which the roof counts, m
     * @param pieces what the roof consists of
     */
    void underRoof(
            Footprint footprint,
            Footprint.Cut cut,
            double bottom,
            double eaves,
            RoofPlanes roof,
            List<Footprint> pieces) {
        lid(footprint, cut, bottom, false);
        for (Footprint piece : pieces) {
            double[] ring = piece.outer();
            int[] found = piece.cut().corners();
            for (int i = 0; i < found.length; i += 3) {
                int[] three = new int[3];
                for (int k = 0; k < 3; k++) {
                    double x = ring[2 * found[i + k]];
                    double y = ring[2 * found[i + k] + 1];
                    three[k] = vertex(x, y, eaves + roof.at(x, y));
                }
                triangle(three[0], three[1], three[2]);
            }
        }
        double[] ring = footprint.outer();
        int last = ring.length - 2;
        for (int i = 0; i < ring.length; i += 2) {
            wall(roof, bottom, eaves, ring[last], ring[last + 1], ring[i], ring[i + 1]);
            last = i;
        }
    }

    private void wall(
            RoofPlanes roof, double bottom, double eaves, double fromX, double fromY, double toX, double toY) {
        List<Integer> top = new ArrayList<>();
        top.add(vertex(toX, toY, eaves + roof.at(toX, toY)));
        double[] breaks = roof.breaks(fromX, fromY, toX, toY);
        for (int i = breaks.length - 1; i >= 0; i--) {
            double x = fromX + breaks[i] * (toX - fromX);
            double y = fromY + breaks[i] * (toY - fromY);
            top.add(vertex(x, y, eaves + roof.at(x, y)));
        }
        top.add(vertex(fromX, fromY, eaves + roof.at(fromX, fromY)));
        int a = vertex(fromX, fromY, bottom);
        triangle(a, vertex(toX, toY, bottom), top.get(0));
        for (int i = 0; i + 1 < top.size(); i++) {
            triangle(a, top.get(i), top.get(i + 1));
        }
    }

    /** All solids so far. */
    TriangleMesh mesh() {
        int[] numbers = new int[materials.size()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = i;
        }
        return new TriangleMesh(
                vertices.toArray(),
                corners.toArray(),
                materials.toArray(),
                numbers,
                List.copyOf(materialNumbers.keySet()));
    }
}
