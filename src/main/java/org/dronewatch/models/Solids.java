package org.dronewatch.models;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Closed solids from which the models are put together. Lengths are metres. */
final class Solids {

    private Solids() {}

    /** Axis-parallel box between two opposite corners. */
    static Solid box(Material material, Point min, Point max) {
        List<Point> bottom = rectangle(min.x(), max.x(), min.z(), max.z(), min.y());
        List<Point> top = rectangle(min.x(), max.x(), min.z(), max.z(), max.y());
        return prism(material, bottom, top);
    }

    /** Box of a given size, standing with the centre of its bottom on {@code foot}. */
    static Solid block(Material material, Point foot, double width, double height, double depth) {
        Point half = new Point(width / 2, 0, depth / 2);
        return box(material, foot.minus(half), foot.plus(half).plus(new Point(0, height, 0)));
    }

    /** Solid between a convex outline and a second one with as many corners; the ends stay single faces. */
    static Solid prism(Material material, List<Point> bottom, List<Point> top) {
        Solid solid = new Solid();
        addBand(solid, material, bottom, top);
        return solid.add(material, reversed(bottom)).add(material, top);
    }

    /** Level plate: a convex outline in plan, given a thickness downward from its height. */
    static Solid plate(Material material, List<Point> outline, double thickness) {
        Point down = new Point(0, -thickness, 0);
        return prism(material, outline.stream().map(p -> p.plus(down)).toList(), outline);
    }

    /** Round bar whose radius changes evenly from one end to the other. */
    static Solid taperedTube(Material material, Point from, double fromRadius, Point to, double toRadius, int sides) {
        Point across = to.minus(from).perpendicular();
        Point other = to.minus(from).unit().cross(across);
        return loft(
                material,
                List.of(ring(from, across, other, fromRadius, sides), ring(to, across, other, toRadius, sides)));
    }

    /** Upright cylinder standing on {@code foot}. */
    static Solid cylinder(Material material, Point foot, double radius, double height, int sides) {
        return taperedTube(material, foot, radius, foot.plus(new Point(0, height, 0)), radius, sides);
    }

    /** Round bar of even thickness along a bent line. */
    static Solid pipe(Material material, List<Point> line, double radius, int sides) {
        List<List<Point>> rings = new ArrayList<>();
        Point across = line.get(1).minus(line.get(0)).perpendicular();
        for (int i = 0; i < line.size(); i++) {
            Point before = line.get(Math.max(i - 1, 0));
            Point along =
                    line.get(Math.min(i + 1, line.size() - 1)).minus(before).unit();
            across = across.minus(along.times(across.dot(along))).unit();
            rings.add(ring(line.get(i), across, along.cross(across), radius, sides));
        }
        return loft(material, rings);
    }

    /** Skin over a row of closed outlines with equally many corners, closed by fans at both ends. */
    static Solid loft(Material material, List<List<Point>> outlines) {
        Solid solid = new Solid();
        for (int i = 0; i + 1 < outlines.size(); i++) {
            addTriangleBand(solid, material, outlines.get(i), outlines.get(i + 1));
        }
        solid.addFan(material, reversed(outlines.get(0)));
        return solid.addFan(material, outlines.get(outlines.size() - 1));
    }

    /** Body along the z axis, of superellipses: position, half width, half height, height of the centre. */
    static Solid lengthwise(Material material, double[][] sections, double exponent) {
        int sides = 36;
        List<List<Point>> outlines = new ArrayList<>();
        for (double[] section : sections) {
            List<Point> outline = new ArrayList<>();
            for (int i = 0; i < sides; i++) {
                double angle = 2 * StrictMath.PI * i / sides;
                double x = section[1] * rounded(StrictMath.cos(angle), exponent);
                double y = section[2] * rounded(StrictMath.sin(angle), exponent);
                outline.add(new Point(x, section[3] + y, section[0]));
            }
            outlines.add(outline);
        }
        return loft(material, outlines);
    }

    private static double rounded(double value, double exponent) {
        return Math.signum(value) * StrictMath.pow(Math.abs(value), 2 / exponent);
    }

    /** Surface of revolution about the upright axis through {@code foot}: pairs of radius and height. */
    static Solid turned(Material material, Point foot, double[][] profile, int sides) {
        List<List<Point>> rings = new ArrayList<>();
        for (double[] radiusAndHeight : profile) {
            Point centre = foot.plus(new Point(0, radiusAndHeight[1], 0));
            rings.add(ring(centre, new Point(0, 0, 1), new Point(1, 0, 0), radiusAndHeight[0], sides));
        }
        return loft(material, rings);
    }

    /** Upright rectangular frame, such as a parapet: outer outline minus inner outline, between two heights. */
    static Solid frame(Material material, double halfX, double halfZ, double thickness, double low, double high) {
        double innerX = halfX - thickness;
        double innerZ = halfZ - thickness;
        List<List<Point>> round = List.of(
                rectangle(-halfX, halfX, -halfZ, halfZ, low),
                rectangle(-halfX, halfX, -halfZ, halfZ, high),
                rectangle(-innerX, innerX, -innerZ, innerZ, high),
                rectangle(-innerX, innerX, -innerZ, innerZ, low));
        Solid solid = new Solid();
        for (int i = 0; i < 4; i++) {
            addBand(solid, material, round.get(i), round.get((i + 1) % 4));
        }
        return solid;
    }

    /** Level rectangle, counter-clockwise from above. */
    static List<Point> rectangle(double minX, double maxX, double minZ, double maxZ, double y) {
        return List.of(
                new Point(minX, y, maxZ), new Point(maxX, y, maxZ), new Point(maxX, y, minZ), new Point(minX, y, minZ));
    }

    /** Regular polygon with its first corner in direction {@code across}. */
    static List<Point> ring(Point centre, Point across, Point other, double radius, int sides) {
        List<Point> ring = new ArrayList<>();
        for (int i = 0; i < sides; i++) {
            double angle = 2 * StrictMath.PI * i / sides;
            Point out = across.times(StrictMath.cos(angle)).plus(other.times(StrictMath.sin(angle)));
            ring.add(centre.plus(out.times(radius)));
        }
        return ring;
    }

    private static void addBand(Solid solid, Material material, List<Point> lower, List<Point> upper) {
        for (int i = 0; i < lower.size(); i++) {
            int next = (i + 1) % lower.size();
            solid.add(material, lower.get(i), lower.get(next), upper.get(next), upper.get(i));
        }
    }

    /** A band of triangles, like a band of quads, but safe where the quads would not be flat. */
    private static void addTriangleBand(Solid solid, Material material, List<Point> lower, List<Point> upper) {
        for (int i = 0; i < lower.size(); i++) {
            int next = (i + 1) % lower.size();
            solid.add(material, lower.get(i), lower.get(next), upper.get(next));
            solid.add(material, lower.get(i), upper.get(next), upper.get(i));
        }
    }

    private static List<Point> reversed(List<Point> outline) {
        List<Point> backwards = new ArrayList<>(outline);
        Collections.reverse(backwards);
        return backwards;
    }
}
