package org.dronewatch.buildings;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.IntConsumer;
import org.dronewatch.geometry.Floats;
import org.dronewatch.geometry.Ints;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.terrain.TerrainGround;

/**
 * Woods as solids of uniform height over the ground, whose tops follow the ground: each triangle of a wood is cut along
 * those of the terrain. They are opaque, as dense foliage is.
 */
final class Canopies {
    /** The acoustic surface of the edge of a wood, by its name in the table of surfaces. */
    static final String MATERIAL = "foliage_edge";

    /** Woods in daylight: red, green, blue. */
    static final int COLOUR = 0x3F5B2E;

    private final Optional<TerrainGround> terrain;
    private final double height;
    private final Floats vertices = new Floats();
    private final Ints corners = new Ints();

    /**
     * No woods yet.
     *
     * @param terrain the terrain on which they stand; if empty, they stand on z = 0
     * @param height over the ground, m
     */
    Canopies(Optional<TerrainGround> terrain, double height) {
        this.terrain = terrain;
        this.height = height;
    }

    /** Adds a wood where there is ground below it; returns whether there is any. */
    boolean add(Footprint wood) {
        int before = corners.size();
        double[] all = wood.rings().stream().flatMapToDouble(Arrays::stream).toArray();
        int[] cut = wood.cut().corners();
        for (int i = 0; i < cut.length; i += 3) {
            top(new double[] {
                all[2 * cut[i]], all[2 * cut[i] + 1],
                all[2 * cut[i + 1]], all[2 * cut[i + 1] + 1],
                all[2 * cut[i + 2]], all[2 * cut[i + 2] + 1]
            });
        }
        for (double[] ring : wood.rings()) {
            int last = ring.length - 2;
            for (int i = 0; i < ring.length; i += 2) {
                side(ring[last], ring[last + 1], ring[i], ring[i + 1]);
                last = i;
            }
        }
        return corners.size() > before;
    }

    private void top(double[] triangle) {
        if (terrain.isEmpty()) {
            fan(triangle, OptionalDouble.of(0.0), -1);
            return;
        }
        double[] box = box(triangle);
        near(box, ground -> fan(within(triangle, ground), OptionalDouble.empty(), ground));
    }

    /** Lists each triangle of the ground near a rectangle once. */
    private void near(double[] box, IntConsumer target) {
        Set<Integer> seen = new HashSet<>();
        terrain.orElseThrow().trianglesNear(box[0], box[1], box[2], box[3], ground -> {
            if (seen.add(ground)) {
                target.accept(ground);
            }
        });
    }

    /** Least and greatest x, least and greatest y. */
    private static double[] box(double[] points) {
        double[] box = {points[0], points[0], points[1], points[1]};
        for (int i = 2; i < points.length; i += 2) {
            box[0] = Math.min(box[0], points[i]);
            box[1] = Math.max(box[1], points[i]);
            box[2] = Math.min(box[2], points[i + 1]);
            box[3] = Math.max(box[3], points[i + 1]);
        }
        return box;
    }

    private double ground(int triangle, int corner, int axis) {
        return terrain.orElseThrow().mesh().coordinate(triangle, corner, axis);
    }

    /** The part of a convex polygon that lies over a triangle of the ground. */
    private double[] within(double[] polygon, int triangle) {
        double[] part = polygon;
        for (int k = 0; k < 3 && part.length > 0; k++) {
            double[] outward = outward(triangle, k);
            part = Rings.clipped(part, outward[0], outward[1], outward[2]);
        }
        return part;
    }

    /** The half plane on the inner side of a side of a triangle: {@code a x + b y <= c}. */
    private double[] outward(int triangle, int side) {
        double ax = ground(triangle, side, 0);
        double ay = ground(triangle, side, 1);
        double bx = ground(triangle, (side + 1) % 3, 0);
        double by = ground(triangle, (side + 1) % 3, 1);
        // Triangles of the ground run counter-clockwise as seen from above.
        double a = by - ay;
        double b = ax - bx;
        return new double[] {a, b, a * ax + b * ay};
    }

    private double levelAt(int triangle, double x, double y) {
        double ax = ground(triangle, 0, 0);
        double ay = ground(triangle, 0, 1);
        double bx = ground(triangle, 1, 0) - ax;
        double by = ground(triangle, 1, 1) - ay;
        double cx = ground(triangle, 2, 0) - ax;
        double cy = ground(triangle, 2, 1) - ay;
        double area = bx * cy - by * cx;
        double second = ((x - ax) * cy - (y - ay) * cx) / area;
        double third = ((y - ay) * bx - (x - ax) * by) / area;
        double az = ground(triangle, 0, 2);
        return az + second * (ground(triangle, 1, 2) - az) + third * (ground(triangle, 2, 2) - az);
    }

    private void fan(double[] convex, OptionalDouble level, int triangle) {
        int count = convex.length / 2;
        if (count < 3) {
            return;
        }
        int first = vertices.size() / 3;
        for (int i = 0; i < convex.length; i += 2) {
            double z = level.isPresent() ? level.getAsDouble() : levelAt(triangle, convex[i], convex[i + 1]);
            vertex(convex[i], convex[i + 1], z + height);
        }
        boolean isLeft = Rings.signedArea(convex) > 0.0;
        for (int i = 1; i + 1 < count; i++) {
            corners.add(first);
            corners.add(first + (isLeft ? i : i + 1));
            corners.add(first + (isLeft ? i + 1 : i));
        }
    }

    private void vertex(double x, double y, double z) {
        vertices.add((float) x);
        vertices.add((float) y);
        vertices.add((float) z);
    }

    private void side(double fromX, double fromY, double toX, double toY) {
        if (terrain.isEmpty()) {
            wall(fromX, fromY, 0.0, toX, toY, 0.0);
            return;
        }
        double[] line = {fromX, fromY, toX, toY};
        double[] box = box(line);
        near(box, ground -> over(line, ground));
    }

    /** The part of a side that lies over a triangle of the ground. */
    private void over(double[] line, int triangle) {
        double start = 0.0;
        double end = 1.0;
        for (int k = 0; k < 3; k++) {
            double[] half = outward(triangle, k);
            double from = half[0] * line[0] + half[1] * line[1] - half[2];
            double to = half[0] * line[2] + half[1] * line[3] - half[2];
            if (from > 0.0 && to > 0.0) {
                return;
            }
            if (from > 0.0) {
                start = Math.max(start, from / (from - to));
            } else if (to > 0.0) {
                end = Math.min(end, from / (from - to));
            }
        }
        if (end - start > 1e-9) {
            double ax = line[0] + start * (line[2] - line[0]);
            double ay = line[1] + start * (line[3] - line[1]);
            double bx = line[0] + end * (line[2] - line[0]);
            double by = line[1] + end * (line[3] - line[1]);
            wall(ax, ay, levelAt(triangle, ax, ay), bx, by, levelAt(triangle, bx, by));
        }
    }

    /** Adds an upright wall, which faces outward if the inside of the ring is on the left. */
    private void wall(double ax, double ay, double a, double bx, double by, double b) {
        int first = vertices.size() / 3;
        vertex(ax, ay, a - BuildingLoader.BELOW);
        vertex(bx, by, b - BuildingLoader.BELOW);
        vertex(bx, by, b + height);
        vertex(ax, ay, a + height);
        for (int corner : new int[] {0, 1, 2, 0, 2, 3}) {
            corners.add(first + corner);
        }
    }

    /** All woods so far. */
    TriangleMesh mesh() {
        int[] numbers = new int[corners.size() / 3];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = i;
        }
        return new TriangleMesh(
                vertices.toArray(), corners.toArray(), new int[numbers.length], numbers, List.of(MATERIAL));
    }
}
