package org.dronewatch.report.sheet;

import java.awt.Color;
import org.dronewatch.buildings.land.LandClass;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.parallel.Workers;
import org.dronewatch.world.World;

/**
 * The ground seen from directly above, lit from the north-west. Water is darker and roads are lighter, if the site has
 * the land cover of a map; both are nearly grey, so that they are not taken for the colours of sensors.
 */
public final class ReliefShade {
    /** The colour where there is no ground: paler than any ground except roads, which are paler still. */
    public static final Color NOTHING = new Color(0xeeeeee);

    private static final double[] LIGHT = {-0.48, 0.48, 0.734};
    private static final int[] GROUND = {236, 232, 222};
    private static final int[] WATER = {158, 170, 180};
    private static final int[] ROAD = {255, 255, 255};

    /** The least light of roads: they are light on slopes, too. */
    private static final double LEAST_LIGHT_OF_ROADS = 0.95;

    private final World world;
    private final TriangleMesh mesh;
    private final RayTracer traversal;
    private final double above;
    private final double lowest;
    private final double extent;
    private final double[] normal = new double[3];

    /** The colour of each material, in full light. */
    private final int[][] colours;

    /**
     * The ground of a square area, on the {@link Workers} of the calling thread: red, green and blue of each pixel, row
     * by row from the north-west.
     *
     * @param east east coordinate of the centre, m
     * @param north north coordinate of the centre, m
     * @param side length of a side, m
     * @param pixels number of pixels along a side
     */
    static int[] of(World world, double east, double north, double side, int pixels) {
        int[] colours = new int[pixels * pixels];
        double pixel = side / pixels;
        Workers.forEach(pixels, () -> new ReliefShade(world), (relief, v) -> {
            double y = north + 0.5 * side - (v + 0.5) * pixel;
            for (int u = 0; u < pixels; u++) {
                double x = east - 0.5 * side + (u + 0.5) * pixel;
                colours[v * pixels + u] = relief.shade(x, y);
            }
        });
        return colours;
    }

    private ReliefShade(World world) {
        this.world = world;
        this.mesh = world.mesh();
        this.traversal = world.newRayTracer();
        this.above = world.bounds().maxZ() + 1.0;
        this.lowest = world.bounds().minZ();
        this.extent = Math.max(1e-9, world.bounds().maxZ() - lowest);
        this.colours = world.materialNames().stream().map(ReliefShade::colour).toArray(int[][]::new);
    }

    /** Whether the colour of a pixel says that there is no ground. */
    public static boolean isNothing(int pixel) {
        return (pixel & 0xffffff) == (NOTHING.getRGB() & 0xffffff);
    }

    private static int[] colour(String material) {
        if (material.equals(LandClass.WATER.material())) {
            return WATER;
        }
        return material.equals(LandClass.ROAD.material()) ? ROAD : GROUND;
    }

    /** The colour at a point: pale where the surface faces the light, lighter the higher it is. */
    private int shade(double x, double y) {
        if (!traversal.closestHit(x, y, above, 0.0, 0.0, -1.0, 0.0, Double.POSITIVE_INFINITY)) {
            return NOTHING.getRGB();
        }
        setNormal(traversal.triangle());
        double facing = normal[0] * LIGHT[0] + normal[1] * LIGHT[1] + normal[2] * LIGHT[2];
        double height = above - traversal.distance();
        double rise = (height - lowest) / extent;
        double light = Math.max(0.0, Math.min(1.0, 0.25 + 0.55 * Math.max(0.0, facing) + 0.2 * rise));
        int[] colour = colours[world.material(traversal.triangle(), x, y)];
        return lit(colour, colour == ROAD ? Math.max(LEAST_LIGHT_OF_ROADS, light) : light);
    }

    private static int lit(int[] colour, double light) {
        return (int) (colour[0] * light) << 16 | (int) (colour[1] * light) << 8 | (int) (colour[2] * light);
    }

    /** Sets the unit normal of a triangle, on its upper side. */
    private void setNormal(int triangle) {
        double[] n = normal;
        mesh.normal(triangle, n);
        double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        double scale = 1.0 / Math.copySign(Math.max(Double.MIN_NORMAL, length), n[2]);
        n[0] *= scale;
        n[1] *= scale;
        n[2] *= scale;
    }
}
