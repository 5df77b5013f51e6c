package org.dronewatch.models;

import static org.dronewatch.models.CathedralModel.BAY;
import static org.dronewatch.models.CathedralModel.BAYS;
import static org.dronewatch.models.CathedralModel.HALF_LENGTH_METRES;
import static org.dronewatch.models.CathedralModel.HALF_WIDTH_METRES;
import static org.dronewatch.models.CathedralModel.LIMESTONE;
import static org.dronewatch.models.CathedralModel.NAVE_HALF_WIDTH_METRES;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/** Frames and tracery in front of the panes. */
final class CathedralWindows {
    private static final double HALF = 1.25;
    private static final double ROUND = 0.07;
    private static final int PIECES = 14;

    private CathedralWindows() {}

    static void addTo(MeshBuilder builder) {
        for (double side : new double[] {-1, 1}) {
            String name = side < 0 ? "n" : "s";
            for (int bay = 0; bay < BAYS; bay++) {
                double x = -HALF_LENGTH_METRES + (bay + 0.5) * BAY;
                addWindow(builder, "aisle_" + name + bay, 2, 3.6, onWall(x, side * (HALF_WIDTH_METRES - 0.03)));
                addWindow(builder, "nave_" + name + bay, 9.8, 12, onWall(x, side * (NAVE_HALF_WIDTH_METRES - 0.03)));
            }
        }
        for (int i = 0; i < 5; i++) {
            double angle = StrictMath.toRadians(18 + 36 * i);
            addWindow(builder, "apse_" + i, 5.5, 11.2, inApse(angle));
        }
    }

    /** Takes a window's own frame (x aside, y up) to a wall along the nave. */
    private static UnaryOperator<Point> onWall(double x, double z) {
        return p -> new Point(x + p.x(), p.y(), z);
    }

    private static UnaryOperator<Point> inApse(double middle) {
        double radius = NAVE_HALF_WIDTH_METRES - 0.05;
        return p -> {
            double angle = middle + 0.62 * p.x() / radius;
            return new Point(
                    HALF_LENGTH_METRES + radius * StrictMath.sin(angle), p.y(), radius * StrictMath.cos(angle));
        };
    }

    /** A frame with a pointed head, two lancets with separate heads and a ring above them. */
    private static void addWindow(
            MeshBuilder builder, String name, double sill, double spring, UnaryOperator<Point> placement) {
        add(builder, "frame_" + name, outline(0, HALF, sill, spring), 1.4 * ROUND, placement);
        add(builder, "lancet_a_" + name, outline(-HALF / 2, HALF / 2, sill, spring - 0.3), ROUND, placement);
        add(builder, "lancet_b_" + name, outline(HALF / 2, HALF / 2, sill, spring - 0.3), ROUND, placement);
        List<Point> ring = new ArrayList<>();
        for (int i = 0; i <= PIECES; i++) {
            double angle = 2 * StrictMath.PI * i / PIECES;
            double y = spring + 0.62 + 0.30 * StrictMath.sin(angle);
            ring.add(new Point(0.30 * StrictMath.cos(angle), y, 0));
        }
        // The ends of a whole ring would lie inside each other, so it is made of two half rings, which are plain bars.
        add(builder, "ring_a_" + name, ring.subList(0, PIECES / 2 + 1), ROUND, placement);
        add(builder, "ring_b_" + name, ring.subList(PIECES / 2, PIECES + 1), ROUND, placement);
    }

    private static List<Point> outline(double middle, double half, double sill, double spring) {
        List<Point> line = new ArrayList<>();
        line.add(new Point(middle - half, sill, 0));
        for (int i = 0; i <= PIECES; i++) {
            double share = -StrictMath.cos(StrictMath.PI * i / PIECES);
            double y = spring + 1.1 * half * CathedralModel.pointed(Math.abs(share));
            line.add(new Point(middle + half * share, y, 0));
        }
        line.add(new Point(middle + half, sill, 0));
        return line;
    }

    private static void add(
            MeshBuilder builder, String name, List<Point> line, double radius, UnaryOperator<Point> placement) {
        builder.add(name, Solids.pipe(LIMESTONE, line.stream().map(placement).toList(), radius, 5));
    }
}
