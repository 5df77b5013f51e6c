package org.dronewatch.models;

import java.util.List;
import java.util.stream.IntStream;

/**
 * The inside of a church: a nave under a pointed vault between two aisles, an apse at the east end, piers, arches,
 * ribs, windows, pews, an altar and an organ. The walls, vaults and floor form one closed surface that faces inward;
 * everything that stands in the church consists of closed solids. The nave runs from west (-x) to east; the middle of
 * its floor is at the origin.
 */
public final class CathedralModel {
    /** Half the length of nave and aisles, metres; the apse reaches {@link #NAVE_HALF_WIDTH_METRES} farther east. */
    public static final double HALF_LENGTH_METRES = 30;

    /** Half the width of the nave between the piers' axes, and the radius of the apse, metres. */
    public static final double NAVE_HALF_WIDTH_METRES = 6;

    /** Distance of the outer walls from the middle of the nave, metres. */
    public static final double HALF_WIDTH_METRES = 12;

    /** Height of the crown of the nave's vault, metres. */
    public static final double CROWN_METRES = 19;

    /** Height of the aisles' vaults where they meet the nave, metres. */
    public static final double AISLE_CROWN_METRES = 8.5;

    /** A position in the middle of the nave with nothing within {@link #FREE_RADIUS_METRES} of it. */
    public static final Point FREE_PLACE = new Point(0, 5, 0);

    /** Radius of the clear space around {@link #FREE_PLACE}, metres. */
    public static final double FREE_RADIUS_METRES = 4;

    /** Length of a bay, from pier to pier, metres. */
    static final double BAY = 6;

    static final int BAYS = 10;

    /** Where the nave's vault springs from its walls. */
    static final double SPRING = 14;

    static final double AISLE_SPRING = 6;

    static final Material LIMESTONE = new Material("limestone", 0.74, 0.69, 0.60);
    static final Material PLASTER = new Material("plaster_lime", 0.88, 0.85, 0.78);
    static final Material GLASS = new Material("glass_window", 0.35, 0.45, 0.62);
    static final Material TILES = new Material("ceramic_tiles", 0.55, 0.42, 0.36);
    static final Material WOOD = new Material("wood_16mm", 0.45, 0.31, 0.19);
    static final Material DOOR = new Material("wooden_door", 0.36, 0.23, 0.13);
    static final Material METAL = new Material("metal_sheet", 0.70, 0.71, 0.74);

    private static final int DECIMALS = 3;

    private CathedralModel() {}

    /** The finished model; the same every time. */
    public static Mesh mesh() {
        MeshBuilder builder = new MeshBuilder("cathedral", DECIMALS);
        builder.addFacets("shell", new CathedralShell().facets());
        CathedralStonework.addTo(builder);
        CathedralWindows.addTo(builder);
        CathedralFurniture.addTo(builder);
        return builder.build();
    }

    /** Height of the pointed vault above the nave's floor at a distance from the middle. */
    static double vaultHeight(double z) {
        double share = Math.min(Math.abs(z) / NAVE_HALF_WIDTH_METRES, 1);
        return SPRING + (CROWN_METRES - SPRING) * pointed(share);
    }

    /**
     * A pointed arch of two arcs: height as a fraction of the rise at a distance as a fraction of the half span. Each
     * arc's centre lies on the springing line beyond the middle.
     */
    static double pointed(double share) {
        double centre = 0.35;
        double radius = 1 + centre;
        double height = StrictMath.sqrt(Math.max(radius * radius - (share + centre) * (share + centre), 0));
        return height / StrictMath.sqrt(radius * radius - centre * centre);
    }

    /** Points of a pointed arch across the nave, from its south spring to its north one. */
    static List<Point> vaultArch(double x, double inset, int pieces) {
        return IntStream.rangeClosed(0, pieces)
                .mapToObj(i -> {
                    double z = NAVE_HALF_WIDTH_METRES * StrictMath.cos(StrictMath.PI * i / pieces);
                    return new Point(x, vaultHeight(z) - inset, z);
                })
                .toList();
    }
}
