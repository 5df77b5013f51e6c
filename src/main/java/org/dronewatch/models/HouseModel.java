package org.dronewatch.models;

import java.util.ArrayList;
import java.util.List;

/**
 * A three-storey house with a flat roof that serves as a platform: a parapet, a stair housing and a plinth for a mast
 * in the middle. It stands with its ground floor at height 0 on a foundation that extends below that, so that it fits
 * on a slope. The long side runs from east to west; every part is a closed solid.
 */
public final class HouseModel {
    /** Half the length of the house along x, metres. */
    public static final double HALF_LENGTH_METRES = 12;

    /** Half the depth of the house along z, metres. */
    public static final double HALF_DEPTH_METRES = 8;

    /** Height of the roof platform's floor, metres. */
    public static final double ROOF_METRES = 9.6;

    /** Height of the top of the parapet, metres. */
    public static final double PARAPET_METRES = 10.6;

    /** Height of the top of the plinth in the middle of the roof, metres. */
    public static final double PLINTH_METRES = 10.8;

    /** Depth of the foundation below the ground floor, metres. */
    public static final double FOUNDATION_METRES = 3;

    private static final int DECIMALS = 3;
    private static final int STOREYS = 3;
    private static final double STOREY = ROOF_METRES / STOREYS;

    private static final Material CONCRETE = new Material("concrete", 0.62, 0.61, 0.59);
    private static final Material PLASTER = new Material("plaster", 0.86, 0.82, 0.73);
    private static final Material BRICK = new Material("brick", 0.58, 0.30, 0.22);
    private static final Material WOOD = new Material("wood", 0.42, 0.29, 0.18);
    private static final Material GLASS = new Material("glass", 0.24, 0.34, 0.42);
    private static final Material METAL = new Material("metal", 0.50, 0.52, 0.54);
    private static final Material GRAVEL = new Material("gravel", 0.52, 0.50, 0.47);

    private final MeshBuilder builder = new MeshBuilder("house", DECIMALS);

    private HouseModel() {}

    /** The finished model, with the middle of its ground floor at the origin. */
    public static Mesh mesh() {
        HouseModel house = new HouseModel();
        house.addWalls();
        house.addOpenings();
        house.addRoof();
        return house.builder.build();
    }

    private void addBox(String name, Material material, double x, double y, double z, double dx, double dy, double dz) {
        Point half = new Point(dx / 2, 0, dz / 2);
        Point foot = new Point(x, y, z);
        builder.add(name, Solids.box(material, foot.minus(half), foot.plus(half).plus(new Point(0, dy, 0))));
    }

    private void addWalls() {
        double length = 2 * HALF_LENGTH_METRES;
        double depth = 2 * HALF_DEPTH_METRES;
        addBox("foundation", CONCRETE, 0, -FOUNDATION_METRES, 0, length + 0.4, FOUNDATION_METRES + 0.3, depth + 0.4);
        addBox("ground_floor", BRICK, 0, 0.3, 0, length, STOREY - 0.3, depth);
        addBox("upper_floors", PLASTER, 0, STOREY, 0, length, ROOF_METRES - STOREY - 0.06, depth);
        for (int storey = 1; storey <= STOREYS; storey++) {
            addBox("ledge_" + storey, CONCRETE, 0, storey * STOREY - 0.12, 0, length + 0.24, 0.12, depth + 0.24);
        }
        for (double end : new double[] {-1, 1}) {
            String side = end < 0 ? "west" : "east";
            addBox(
                    "downpipe_" + side,
                    METAL,
                    end * (HALF_LENGTH_METRES - 0.5),
                    0,
                    HALF_DEPTH_METRES + 0.18,
                    0.12,
                    9.5,
                    0.12);
        }
    }

    private void addOpenings() {
        for (int storey = 0; storey < STOREYS; storey++) {
            double sill = storey * STOREY + 1.0;
            for (int i = 0; i < 7; i++) {
                double along = (i - 3) * 3.2;
                if (storey > 0 || i != 3) {
                    addWindow("window_n" + storey + i, along, sill, -1, true);
                }
                addWindow("window_s" + storey + i, along, sill, 1, true);
            }
            for (int i = 0; i < 4; i++) {
                double along = (i - 1.5) * 3.6;
                addWindow("window_w" + storey + i, along, sill, -1, false);
                addWindow("window_e" + storey + i, along, sill, 1, false);
            }
        }
        addBox("door", WOOD, 0, 0.3, -HALF_DEPTH_METRES - 0.03, 1.8, 2.3, 0.06);
        addBox("canopy", CONCRETE, 0, 2.75, -HALF_DEPTH_METRES - 0.9, 3.4, 0.15, 1.8);
        for (double side : new double[] {-1, 1}) {
            Point foot = new Point(1.5 * side, 0.3, -HALF_DEPTH_METRES - 1.6);
            builder.add("post_" + (side < 0 ? "west" : "east"), Solids.cylinder(METAL, foot, 0.07, 2.45, 16));
        }
        for (int step = 0; step < 2; step++) {
            double out = 0.95 + 0.35 * step;
            addBox("step_" + step, CONCRETE, 0, -0.6, -HALF_DEPTH_METRES - out, 3.0, 0.9 - 0.15 * (step + 1), 1.9);
        }
    }

    /** A pane and the four bars of its frame, standing out from the wall. */
    private void addWindow(String name, double along, double sill, double side, boolean longWall) {
        double wide = 1.5;
        double high = 1.5;
        double bar = 0.1;
        addOnWall(name + "_pane", GLASS, along, sill, wide, high, 0.03, side, longWall);
        for (double end : new double[] {-1, 1}) {
            String which = end < 0 ? "a" : "b";
            double centre = along + end * (wide + bar) / 2;
            addOnWall(name + "_jamb_" + which, WOOD, centre, sill - bar, bar, high + 2 * bar, 0.08, side, longWall);
        }
        addOnWall(name + "_head", WOOD, along, sill + high, wide, bar, 0.08, side, longWall);
        addOnWall(name + "_sill", CONCRETE, along, sill - bar, wide, bar, 0.16, side, longWall);
    }

    private void addOnWall(
            String name,
            Material material,
            double along,
            double low,
            double wide,
            double high,
            double out,
            double side,
            boolean longWall) {
        double wall = side * ((longWall ? HALF_DEPTH_METRES : HALF_LENGTH_METRES) + out / 2);
        if (longWall) {
            addBox(name, material, along, low, wall, wide, high, out);
        } else {
            addBox(name, material, wall, low, along, out, high, wide);
        }
    }

    private void addRoof() {
        addBox(
                "roof_cover",
                GRAVEL,
                0,
                ROOF_METRES - 0.1,
                0,
                2 * HALF_LENGTH_METRES - 0.6,
                0.1,
                2 * HALF_DEPTH_METRES - 0.6);
        double thickness = 0.3;
        builder.add(
                "parapet",
                Solids.frame(
                        PLASTER,
                        HALF_LENGTH_METRES,
                        HALF_DEPTH_METRES,
                        thickness,
                        ROOF_METRES - 0.06,
                        PARAPET_METRES - 0.06));
        builder.add(
                "coping",
                Solids.frame(
                        METAL,
                        HALF_LENGTH_METRES + 0.04,
                        HALF_DEPTH_METRES + 0.04,
                        thickness + 0.08,
                        PARAPET_METRES - 0.06,
                        PARAPET_METRES));
        addBox("stair_head", PLASTER, -7.5, ROOF_METRES, 4.6, 4.0, 2.4, 3.2);
        addBox("stair_roof", METAL, -7.5, ROOF_METRES + 2.4, 4.6, 4.4, 0.12, 3.6);
        addBox("stair_door", WOOD, -5.47, ROOF_METRES, 4.6, 0.06, 2.0, 1.0);
        addBox("plinth", CONCRETE, 0, ROOF_METRES, 0, 1.2, PLINTH_METRES - ROOF_METRES, 1.2);
        List<Point> flue = new ArrayList<>(Solids.rectangle(5.7, 6.3, 3.7, 4.3, ROOF_METRES));
        List<Point> top = flue.stream().map(p -> p.plus(new Point(0, 1.6, 0))).toList();
        builder.add("chimney", Solids.prism(BRICK, flue, top));
        addBox("air_handler", METAL, 7.0, ROOF_METRES, -3.5, 2.2, 1.3, 1.4);
    }
}
