package org.dronewatch.models;

import static org.dronewatch.models.CathedralModel.AISLE_CROWN_METRES;
import static org.dronewatch.models.CathedralModel.AISLE_SPRING;
import static org.dronewatch.models.CathedralModel.BAY;
import static org.dronewatch.models.CathedralModel.BAYS;
import static org.dronewatch.models.CathedralModel.HALF_LENGTH_METRES;
import static org.dronewatch.models.CathedralModel.HALF_WIDTH_METRES;
import static org.dronewatch.models.CathedralModel.LIMESTONE;
import static org.dronewatch.models.CathedralModel.NAVE_HALF_WIDTH_METRES;
import static org.dronewatch.models.CathedralModel.SPRING;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Piers, the arches between them with their walls, and the ribs of the vaults. */
final class CathedralStonework {
    private static final double CAPITAL = 4.8;
    private static final double ARCH_RISE = 3.1;
    private static final double PIER_RADIUS = 0.55;
    private static final double WALL_HALF = 0.45;
    private static final int ARCH_PIECES = 24;

    private CathedralStonework() {}

    static void addTo(MeshBuilder builder) {
        for (double side : new double[] {-1, 1}) {
            String name = side < 0 ? "n" : "s";
            for (int i = 1; i < BAYS; i++) {
                double x = -HALF_LENGTH_METRES + i * BAY;
                addPier(builder, name + i, x, side);
                addAisleRib(builder, name + i, x, side);
            }
            for (int bay = 0; bay < BAYS; bay++) {
                addArch(builder, name + bay, -HALF_LENGTH_METRES + bay * BAY, side);
            }
        }
        addNaveRibs(builder);
    }

    private static void addPier(MeshBuilder builder, String name, double x, double side) {
        double[][] profile = {
            {0.95, 0.00},
            {0.95, 0.25},
            {0.90, 0.30},
            {0.90, 0.42},
            {0.80, 0.48},
            {0.84, 0.56},
            {0.80, 0.64},
            {0.66, 0.70},
            {0.70, 0.78},
            {0.62, 0.86},
            {PIER_RADIUS, 0.95},
            {PIER_RADIUS, 2.2},
            {PIER_RADIUS, 3.4},
            {PIER_RADIUS, 3.9},
            {0.62, 3.96},
            {0.62, 4.04},
            {PIER_RADIUS, 4.10},
            {0.60, 4.25},
            {0.70, 4.45},
            {0.84, 4.60},
            {0.92, 4.66},
            {0.92, CAPITAL}
        };
        Point foot = new Point(x, 0, side * NAVE_HALF_WIDTH_METRES);
        builder.add("pier_" + name, Solids.turned(LIMESTONE, foot, profile, 28));
        Point shaft = new Point(x, CAPITAL - 0.1, side * (NAVE_HALF_WIDTH_METRES - WALL_HALF));
        builder.add("shaft_" + name, Solids.cylinder(LIMESTONE, shaft, 0.16, SPRING - CAPITAL + 0.3, 16));
    }

    /** The wall over one bay's arch, from the intrados up to the aisle's crown, and a roll along both its edges. */
    private static void addArch(MeshBuilder builder, String name, double west, double side) {
        double middle = west + BAY / 2;
        double half = BAY / 2 - PIER_RADIUS;
        double top = AISLE_CROWN_METRES + 0.2;
        List<Point> intrados = new ArrayList<>();
        for (int i = 0; i <= ARCH_PIECES; i++) {
            double share = -StrictMath.cos(StrictMath.PI * i / ARCH_PIECES);
            double y = CAPITAL + ARCH_RISE * CathedralModel.pointed(Math.abs(share));
            intrados.add(new Point(middle + half * share, y, 0));
        }
        Point toNave = new Point(0, 0, side * NAVE_HALF_WIDTH_METRES - WALL_HALF);
        Point toAisle = new Point(0, 0, side * NAVE_HALF_WIDTH_METRES + WALL_HALF);
        Solid wall = new Solid();
        for (int i = 0; i < ARCH_PIECES; i++) {
            Point a = intrados.get(i);
            Point b = intrados.get(i + 1);
            Point aTop = new Point(a.x(), top, 0);
            Point bTop = new Point(b.x(), top, 0);
            wall.add(LIMESTONE, a.plus(toNave), b.plus(toNave), b.plus(toAisle), a.plus(toAisle));
            wall.add(LIMESTONE, aTop.plus(toAisle), bTop.plus(toAisle), bTop.plus(toNave), aTop.plus(toNave));
            wall.add(LIMESTONE, aTop.plus(toNave), bTop.plus(toNave), b.plus(toNave), a.plus(toNave));
            wall.add(LIMESTONE, a.plus(toAisle), b.plus(toAisle), bTop.plus(toAisle), aTop.plus(toAisle));
        }
        for (int end : new int[] {0, ARCH_PIECES}) {
            Point a = intrados.get(end);
            Point aTop = new Point(a.x(), top, 0);
            List<Point> face = List.of(a.plus(toNave), a.plus(toAisle), aTop.plus(toAisle), aTop.plus(toNave));
            List<Point> turned = new ArrayList<>(face);
            Collections.reverse(turned);
            wall.add(LIMESTONE, end == 0 ? face : turned);
        }
        builder.add("arch_" + name, wall);
        builder.add("roll_nave_" + name, roll(intrados, toNave));
        builder.add("roll_aisle_" + name, roll(intrados, toAisle));
        for (double end : new double[] {west, west + BAY}) {
            double inward = end == west ? PIER_RADIUS / 2 : -PIER_RADIUS / 2;
            Point foot = new Point(end + inward, CAPITAL, side * NAVE_HALF_WIDTH_METRES);
            builder.add(
                    "spandrel_" + name + (end == west ? "w" : "e"),
                    Solids.block(LIMESTONE, foot, PIER_RADIUS, top - CAPITAL, 2 * WALL_HALF));
        }
    }

    private static Solid roll(List<Point> intrados, Point offset) {
        return Solids.pipe(LIMESTONE, intrados.stream().map(p -> p.plus(offset)).toList(), 0.10, 6);
    }

    private static void addAisleRib(MeshBuilder builder, String name, double x, double side) {
        List<Point> line = new ArrayList<>();
        int pieces = 16;
        for (int i = 0; i <= pieces; i++) {
            double angle = 0.5 * StrictMath.PI * i / pieces;
            double z = NAVE_HALF_WIDTH_METRES + (HALF_WIDTH_METRES - NAVE_HALF_WIDTH_METRES) * StrictMath.cos(angle);
            double y = AISLE_SPRING + (AISLE_CROWN_METRES - AISLE_SPRING) * StrictMath.sin(angle);
            line.add(new Point(x, y, side * z));
        }
        builder.add("aisle_rib_" + name, Solids.pipe(LIMESTONE, line, 0.14, 10));
        Point foot = new Point(x, 0, side * (HALF_WIDTH_METRES - 0.02));
        builder.add("pilaster_" + name, Solids.cylinder(LIMESTONE, foot, 0.18, AISLE_SPRING, 14));
    }

    private static void addNaveRibs(MeshBuilder builder) {
        for (int i = 0; i <= BAYS; i++) {
            double x = -HALF_LENGTH_METRES + i * BAY;
            builder.add("rib_" + i, Solids.pipe(LIMESTONE, CathedralModel.vaultArch(x, 0.02, 36), 0.20, 10));
        }
        int pieces = 30;
        for (int bay = 0; bay < BAYS; bay++) {
            for (int diagonal = 0; diagonal < 2; diagonal++) {
                List<Point> line = new ArrayList<>();
                for (int i = 0; i <= pieces; i++) {
                    double z = NAVE_HALF_WIDTH_METRES * StrictMath.cos(StrictMath.PI * i / pieces);
                    double share = 0.5 * (1 + (diagonal == 0 ? z : -z) / NAVE_HALF_WIDTH_METRES);
                    double x = -HALF_LENGTH_METRES + (bay + share) * BAY;
                    line.add(new Point(x, CathedralModel.vaultHeight(z) - 0.02, z));
                }
                builder.add("diagonal_" + bay + (diagonal == 0 ? "a" : "b"), Solids.pipe(LIMESTONE, line, 0.13, 8));
            }
        }
    }
}
