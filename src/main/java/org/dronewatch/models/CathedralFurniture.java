package org.dronewatch.models;

import static org.dronewatch.models.CathedralModel.DOOR;
import static org.dronewatch.models.CathedralModel.HALF_LENGTH_METRES;
import static org.dronewatch.models.CathedralModel.LIMESTONE;
import static org.dronewatch.models.CathedralModel.METAL;
import static org.dronewatch.models.CathedralModel.WOOD;

/** Pews, altar, organ and west door. */
final class CathedralFurniture {
    private static final int ROWS = 22;

    private CathedralFurniture() {}

    static void addTo(MeshBuilder builder) {
        for (int row = 0; row < ROWS; row++) {
            for (double side : new double[] {-1, 1}) {
                addPew(builder, (side < 0 ? "n" : "s") + row, -20 + 1.6 * row, 2.8 * side);
            }
        }
        addAltar(builder);
        addOrgan(builder);
        addBlock(builder, "door", DOOR, -HALF_LENGTH_METRES + 0.05, 0, 0, 0.1, 4.2, 3.2);
        addBlock(builder, "lintel", LIMESTONE, -HALF_LENGTH_METRES + 0.15, 4.2, 0, 0.3, 0.5, 4.0);
    }

    private static void addBlock(
            MeshBuilder builder,
            String name,
            Material material,
            double x,
            double y,
            double z,
            double dx,
            double dy,
            double dz) {
        builder.add(name, Solids.block(material, new Point(x, y, z), dx, dy, dz));
    }

    private static void addPew(MeshBuilder builder, String name, double x, double z) {
        double width = 4.2;
        addBlock(builder, "seat_" + name, WOOD, x, 0.42, z, 0.42, 0.04, width);
        addBlock(builder, "back_" + name, WOOD, x - 0.22, 0.30, z, 0.04, 0.62, width);
        addBlock(builder, "kneeler_" + name, WOOD, x + 0.55, 0.12, z, 0.22, 0.05, width);
        for (double end : new double[] {-1, 1}) {
            String which = name + (end < 0 ? "a" : "b");
            addBlock(builder, "cheek_" + which, WOOD, x, 0, z + end * (width / 2 + 0.03), 0.60, 0.95, 0.06);
        }
    }

    private static void addAltar(MeshBuilder builder) {
        double x = HALF_LENGTH_METRES + 0.5;
        for (int step = 0; step < 3; step++) {
            double half = 2.6 - 0.5 * step;
            addBlock(builder, "step_" + step, LIMESTONE, x, 0.17 * step, 0, 2 * half, 0.17, 2.6 * half);
        }
        addBlock(builder, "altar", LIMESTONE, x, 0.51, 0, 1.0, 0.95, 2.4);
        addBlock(builder, "mensa", LIMESTONE, x, 1.46, 0, 1.3, 0.12, 2.9);
    }

    /** A gallery over the door with the organ's case and pipes on it. */
    private static void addOrgan(MeshBuilder builder) {
        double x = -HALF_LENGTH_METRES + 2.2;
        addBlock(builder, "gallery", WOOD, x, 6.0, 0, 4.4, 0.35, 11.0);
        addBlock(builder, "rail", WOOD, x + 2.15, 6.35, 0, 0.1, 1.0, 11.0);
        addBlock(builder, "case", WOOD, x - 1.3, 6.35, 0, 1.6, 2.2, 7.0);
        for (int i = 0; i < 33; i++) {
            double beside = (i - 16) / 16.0;
            double height = 2.4 + 2.6 * beside * beside;
            Point foot = new Point(x - 0.65, 8.4, 3.3 * beside);
            double[][] profile = {{0.02, 0}, {0.085, 0.5}, {0.085, 0.5 + height}};
            builder.add("pipe_" + i, Solids.turned(METAL, foot, profile, 16));
        }
    }
}
