package org.dronewatch.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.mesh.io.ModelRole;

/**
 * All surfaces of a world on the vertical through a point, the highest first.
 *
 * @param surfaces the surfaces; empty where there are none
 */
public record SurfaceColumn(List<Surface> surfaces) {
    /** Surfaces that are closer together than this count as one, m. */
    private static final double APART = 1e-3;

    /** The greatest number of surfaces that are looked for. */
    private static final int MOST = 1000;

    /**
     * A surface.
     *
     * @param z its height, m
     * @param what model and material of the surface
     * @param facesUp whether its corners run counter-clockwise as seen from above, that is, it is not an underside
     */
    public record Surface(double z, Obstacle what, boolean facesUp) {}

    /** Copies the list: later changes by the caller have no effect. */
    public SurfaceColumn {
        surfaces = List.copyOf(surfaces);
    }

    /**
     * The surfaces at a point.
     *
     * @param x east, m
     * @param y north, m
     */
    public static SurfaceColumn at(World world, double x, double y) {
        RayTracer tracer = world.newRayTracer();
        TriangleMesh mesh = world.mesh();
        double[] normal = new double[3];
        double above = world.bounds().maxZ() + 1.0;
        List<Surface> found = new ArrayList<>();
        double from = 0.0;
        while (found.size() < MOST && tracer.closestHit(x, y, above, 0.0, 0.0, -1.0, from, Double.POSITIVE_INFINITY)) {
            mesh.normal(tracer.triangle(), normal);
            found.add(new Surface(above - tracer.distance(), world.obstacle(tracer.triangle(), x, y), normal[2] > 0.0));
            from = tracer.distance() + APART;
        }
        return new SurfaceColumn(found);
    }

    /** The highest surface; empty where there is none. */
    public Optional<Surface> highest() {
        return surfaces.stream().findFirst();
    }

    /** The highest upward-facing surface at or below a height, m; empty if there is none. */
    public Optional<Surface> standing(double z) {
        return surfaces.stream()
                .filter(surface -> surface.facesUp() && surface.z() <= z)
                .findFirst();
    }

    /**
     * Whether a height, m, is inside something solid: the nearest surface above it faces up, so that it is seen from
     * behind.
     */
    public boolean isInside(double z) {
        boolean inside = false;
        for (Surface surface : surfaces) {
            if (surface.z() <= z) {
                return inside;
            }
            inside = surface.facesUp();
        }
        return inside;
    }

    /**
     * The highest surface of terrain; if there is no terrain, the lowest surface that faces up; empty if there is
     * neither.
     */
    public Optional<Surface> ground() {
        return surfaces.stream()
                .filter(surface -> surface.what().model().role() == ModelRole.TERRAIN)
                .findFirst()
                .or(() -> surfaces.stream().filter(Surface::facesUp).reduce((high, low) -> low));
    }
}
