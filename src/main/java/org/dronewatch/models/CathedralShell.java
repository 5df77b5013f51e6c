package org.dronewatch.models;

import static org.dronewatch.models.CathedralModel.AISLE_CROWN_METRES;
import static org.dronewatch.models.CathedralModel.AISLE_SPRING;
import static org.dronewatch.models.CathedralModel.BAY;
import static org.dronewatch.models.CathedralModel.BAYS;
import static org.dronewatch.models.CathedralModel.GLASS;
import static org.dronewatch.models.CathedralModel.HALF_LENGTH_METRES;
import static org.dronewatch.models.CathedralModel.HALF_WIDTH_METRES;
import static org.dronewatch.models.CathedralModel.LIMESTONE;
import static org.dronewatch.models.CathedralModel.NAVE_HALF_WIDTH_METRES;
import static org.dronewatch.models.CathedralModel.PLASTER;
import static org.dronewatch.models.CathedralModel.SPRING;
import static org.dronewatch.models.CathedralModel.TILES;

import java.util.ArrayList;
import java.util.List;

/**
 * The skin of the church's air, without a gap: the cross-section drawn from west to east, a wall at the west end, walls
 * at the aisles' east ends, and the apse as half the nave's section turned about its axis. All of them share their
 * border points, so that every edge belongs to two faces, which run along it in opposite directions. Faces look inward.
 */
final class CathedralShell {
    private static final int SLICES = 100;
    private static final int FLOOR_PIECES = 20;
    private static final int WALL_PIECES = 12;
    private static final int VAULT_PIECES = 18;
    private static final int APSE_PIECES = 36;

    /** A point of the cross-section: distance from the middle and height. */
    private record Corner(double z, double y) {}

    private final List<Solid.Facet> facets = new ArrayList<>();

    List<Solid.Facet> facets() {
        addNaveAndAisles();
        addFan(-HALF_LENGTH_METRES, new Corner(0, 6), section(), true);
        addFan(HALF_LENGTH_METRES, new Corner(9, 3), southAisle(), false);
        addFan(HALF_LENGTH_METRES, new Corner(-9, 3), northAisle(), false);
        addApse();
        return facets;
    }

    /** The outline of the section, counter-clockwise when seen from the east: floor, south side, vault, north side. */
    private static List<Corner> section() {
        List<Corner> outline = new ArrayList<>();
        addStraight(outline, new Corner(-HALF_WIDTH_METRES, 0), new Corner(-NAVE_HALF_WIDTH_METRES, 0), WALL_PIECES);
        addStraight(outline, new Corner(-NAVE_HALF_WIDTH_METRES, 0), new Corner(0, 0), FLOOR_PIECES / 2);
        addStraight(outline, new Corner(0, 0), new Corner(NAVE_HALF_WIDTH_METRES, 0), FLOOR_PIECES / 2);
        addStraight(outline, new Corner(NAVE_HALF_WIDTH_METRES, 0), new Corner(HALF_WIDTH_METRES, 0), WALL_PIECES);
        List<Corner> south = southSide();
        outline.addAll(south);
        for (int i = south.size() - 2; i > 0; i--) {
            outline.add(new Corner(-south.get(i).z(), south.get(i).y()));
        }
        outline.add(new Corner(-HALF_WIDTH_METRES, 0));
        return outline.subList(0, outline.size() - 1);
    }

    /**
     * The outline from the foot of the south wall over the aisle's vault and the nave's wall to the crown, which is its
     * last point.
     */
    private static List<Corner> southSide() {
        List<Corner> side = new ArrayList<>();
        addStraight(side, new Corner(HALF_WIDTH_METRES, 0), new Corner(HALF_WIDTH_METRES, AISLE_SPRING), WALL_PIECES);
        side.addAll(aisleVault());
        side.addAll(upperNave());
        return side;
    }

    /** A quarter of an ellipse from the outer wall up to the nave's wall, without its end. */
    private static List<Corner> aisleVault() {
        List<Corner> vault = new ArrayList<>();
        for (int i = 0; i < WALL_PIECES; i++) {
            double angle = 0.5 * StrictMath.PI * i / WALL_PIECES;
            double z = NAVE_HALF_WIDTH_METRES + (HALF_WIDTH_METRES - NAVE_HALF_WIDTH_METRES) * StrictMath.cos(angle);
            vault.add(new Corner(z, AISLE_SPRING + (AISLE_CROWN_METRES - AISLE_SPRING) * StrictMath.sin(angle)));
        }
        return vault;
    }

    /** The nave's wall above the aisle, then its vault up to the crown. */
    private static List<Corner> upperNave() {
        List<Corner> upper = new ArrayList<>();
        addStraight(
                upper,
                new Corner(NAVE_HALF_WIDTH_METRES, AISLE_CROWN_METRES),
                new Corner(NAVE_HALF_WIDTH_METRES, SPRING),
                WALL_PIECES);
        for (int i = 0; i <= VAULT_PIECES; i++) {
            double z = NAVE_HALF_WIDTH_METRES * StrictMath.cos(0.5 * StrictMath.PI * i / VAULT_PIECES);
            upper.add(new Corner(i == VAULT_PIECES ? 0 : z, CathedralModel.vaultHeight(z)));
        }
        return upper;
    }

    /** The line between aisle and nave from the floor up to the aisle's crown, without its end. */
    private static List<Corner> arcadeLine(double side) {
        List<Corner> line = new ArrayList<>();
        addStraight(
                line,
                new Corner(side * NAVE_HALF_WIDTH_METRES, 0),
                new Corner(side * NAVE_HALF_WIDTH_METRES, AISLE_CROWN_METRES),
                WALL_PIECES);
        return line;
    }

    private static List<Corner> southAisle() {
        List<Corner> loop = new ArrayList<>();
        addStraight(loop, new Corner(NAVE_HALF_WIDTH_METRES, 0), new Corner(HALF_WIDTH_METRES, 0), WALL_PIECES);
        addStraight(loop, new Corner(HALF_WIDTH_METRES, 0), new Corner(HALF_WIDTH_METRES, AISLE_SPRING), WALL_PIECES);
        loop.addAll(aisleVault());
        loop.add(new Corner(NAVE_HALF_WIDTH_METRES, AISLE_CROWN_METRES));
        List<Corner> line = arcadeLine(1);
        for (int i = line.size() - 1; i > 0; i--) {
            loop.add(line.get(i));
        }
        return loop;
    }

    private static List<Corner> northAisle() {
        List<Corner> loop = new ArrayList<>();
        List<Corner> south = southAisle();
        for (int i = south.size() - 1; i >= 0; i--) {
            loop.add(new Corner(-south.get(i).z(), south.get(i).y()));
        }
        return loop;
    }

    /** Evenly spaced points from one corner towards another, without the other. */
    private static void addStraight(List<Corner> outline, Corner from, Corner to, int pieces) {
        for (int i = 0; i < pieces; i++) {
            double share = (double) i / pieces;
            outline.add(new Corner(from.z() + share * (to.z() - from.z()), from.y() + share * (to.y() - from.y())));
        }
    }

    private void addNaveAndAisles() {
        List<Corner> section = section();
        for (int slice = 0; slice < SLICES; slice++) {
            double west = -HALF_LENGTH_METRES + 2 * HALF_LENGTH_METRES * slice / SLICES;
            double east = -HALF_LENGTH_METRES + 2 * HALF_LENGTH_METRES * (slice + 1) / SLICES;
            for (int k = 0; k < section.size(); k++) {
                Corner a = section.get(k);
                Corner b = section.get((k + 1) % section.size());
                add(at(west, a), at(west, b), at(east, b), at(east, a));
            }
        }
    }

    private static Point at(double x, Corner corner) {
        return new Point(x, corner.y(), corner.z());
    }

    private void addFan(double x, Corner middle, List<Corner> loop, boolean facingEast) {
        for (int k = 0; k < loop.size(); k++) {
            Point a = at(x, loop.get(k));
            Point b = at(x, loop.get((k + 1) % loop.size()));
            facets.add(new Solid.Facet(
                    LIMESTONE, facingEast ? List.of(at(x, middle), b, a) : List.of(at(x, middle), a, b)));
        }
    }

    private void addApse() {
        List<Corner> half = new ArrayList<>(arcadeLine(1));
        half.addAll(upperNave());
        addTurned(half);
        List<Corner> floor = new ArrayList<>();
        addStraight(floor, new Corner(0, 0), new Corner(NAVE_HALF_WIDTH_METRES, 0), FLOOR_PIECES / 2);
        floor.add(new Corner(NAVE_HALF_WIDTH_METRES, 0));
        addTurned(floor);
    }

    /** Turns a line from the south over the east to the north about the upright axis at the nave's east end. */
    private void addTurned(List<Corner> line) {
        for (int i = 0; i < APSE_PIECES; i++) {
            for (int k = 0; k + 1 < line.size(); k++) {
                add(
                        turned(line.get(k), i),
                        turned(line.get(k + 1), i),
                        turned(line.get(k + 1), i + 1),
                        turned(line.get(k), i + 1));
            }
        }
    }

    private static Point turned(Corner corner, int piece) {
        double angle = StrictMath.PI * piece / APSE_PIECES;
        return new Point(
                HALF_LENGTH_METRES + corner.z() * StrictMath.sin(angle),
                corner.y(),
                corner.z() * StrictMath.cos(angle));
    }

    private void add(Point a, Point b, Point c, Point d) {
        facets.add(new Solid.Facet(material(Solid.centre(List.of(a, b, c, d))), List.of(a, b, c, d)));
    }

    private static Material material(Point point) {
        if (point.y() < 1e-9) {
            return TILES;
        }
        double out = Math.abs(point.z());
        boolean aisle = point.x() < HALF_LENGTH_METRES && out > NAVE_HALF_WIDTH_METRES + 1e-9;
        double spring = aisle ? AISLE_SPRING : SPRING;
        if (point.y() > spring) {
            return PLASTER;
        }
        return isWindow(point, aisle) ? GLASS : LIMESTONE;
    }

    /** One window in the middle of each bay of the aisles' and the nave's walls, five in the apse. */
    private static boolean isWindow(Point point, boolean aisle) {
        if (point.x() > HALF_LENGTH_METRES) {
            double angle = StrictMath.toDegrees(StrictMath.atan2(point.x() - HALF_LENGTH_METRES, point.z()));
            double beside = Math.abs(angle - 36 * Math.floor(angle / 36) - 18);
            return beside < 7.5 && point.y() > 5.5 && point.y() < 12.5;
        }
        double bay = (point.x() + HALF_LENGTH_METRES) / BAY;
        double beside = Math.abs(bay - Math.floor(bay) - 0.5) * BAY;
        boolean high = aisle ? point.y() > 2 && point.y() < 5 : point.y() > 9.8 && point.y() < 13.2;
        return bay < BAYS && beside < 1.2 && high;
    }
}
