package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.world.World;

/**
 * The coincident faces at a point where a path of sound meets one of them, grouped by material: the path crosses all of
 * them at once. The path leaves the solids that it is inside, and enters the others. Coincident faces of a sheet count
 * as one. Coincident faces of a solid also count as one when the path enters it; if n faces were merged then, at most n
 * are merged when the path leaves the solid. For use by one thread.
 */
public final class CrossedFaces {
    /**
     * A point at which the weight of a corner is no more than this counts as lying on the opposite edge: greater than
     * the rounding error of points.
     */
    private static final double EDGE = 1e-9;

    private final World world;
    private final TriangleMesh mesh;
    private final BandSurfaces surfaces;
    private final double[] normal = new double[3];
    private final double[] weights = new double[3];

    private int[] materials = new int[4];
    private int[] triangles = new int[4];

    /** Twice the number of faces: a face that is met on an edge counts half, since it has a neighbour there. */
    private int[] halves = new int[4];

    private TouchingFaces touching;
    private int count;
    private double beyond;

    /** A search among the faces of a world, without any faces found yet. */
    public CrossedFaces(World world, BandSurfaces surfaces) {
        this.world = world;
        this.mesh = world.mesh();
        this.surfaces = surfaces;
    }

    /** Finds the faces at the origin of a ray, which has met one of them there. */
    public void find(int triangle, int material, AcousticRay ray) {
        find(triangle, material, ray.originX, ray.originY, ray.originZ, ray.directionX, ray.directionY, ray.directionZ);
    }

    /**
     * Finds the faces at a point.
     *
     * @param triangle the triangle that the path meets there
     * @param material material of that triangle
     * @param x x coordinate of the point, m
     * @param alongX x component of the path's direction, which may have any length
     */
    public void find(
            int triangle, int material, double x, double y, double z, double alongX, double alongY, double alongZ) {
        count = 0;
        beyond = 0.0;
        add(triangle, material, 2);
        if (touching == null) {
            // Needed only where sound passes through walls.
            touching = TouchingFaces.of(world);
        }
        for (int other : touching.of(triangle)) {
            mesh.normal(other, normal);
            double size = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
            double height = (mesh.coordinate(other, 0, 0) - x) * normal[0]
                    + (mesh.coordinate(other, 0, 1) - y) * normal[1]
                    + (mesh.coordinate(other, 0, 2) - z) * normal[2];
            double least = Math.abs(height) <= touching.tolerance() * size ? leastWeight(other, x, y, z) : -1.0;
            if (least >= -EDGE) {
                add(other, world.material(other, x, y), least > EDGE ? 2 : 1);
                double slope = alongX * normal[0] + alongY * normal[1] + alongZ * normal[2];
                beyond = slope == 0.0 ? beyond : Math.max(beyond, height / slope);
            }
        }
    }

    /** The least of the barycentric coordinates of a point in a triangle: negative outside the triangle. */
    private double leastWeight(int triangle, double x, double y, double z) {
        double square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        for (int corner = 0; corner < 3; corner++) {
            int next = (corner + 1) % 3;
            double fromX = mesh.coordinate(triangle, corner, 0);
            double fromY = mesh.coordinate(triangle, corner, 1);
            double fromZ = mesh.coordinate(triangle, corner, 2);
            double edgeX = mesh.coordinate(triangle, next, 0) - fromX;
            double edgeY = mesh.coordinate(triangle, next, 1) - fromY;
            double edgeZ = mesh.coordinate(triangle, next, 2) - fromZ;
            weights[corner] = (normal[0] * (edgeY * (z - fromZ) - edgeZ * (y - fromY))
                            + normal[1] * (edgeZ * (x - fromX) - edgeX * (z - fromZ))
                            + normal[2] * (edgeX * (y - fromY) - edgeY * (x - fromX)))
                    / square;
        }
        return Math.min(weights[0], Math.min(weights[1], weights[2]));
    }

    private void add(int triangle, int material, int half) {
        int i = 0;
        while (i < count && materials[i] != material) {
            i++;
        }
        if (i < count) {
            halves[i] += half;
            return;
        }
        if (count == materials.length) {
            materials = Arrays.copyOf(materials, 2 * count);
            triangles = Arrays.copyOf(triangles, 2 * count);
            halves = Arrays.copyOf(halves, 2 * count);
        }
        materials[count] = material;
        triangles[count] = triangle;
        halves[count] = half;
        count++;
    }

    /** The number of materials of these faces. */
    public int count() {
        return count;
    }

    /** The index, in the world, of one of these faces' materials, which are numbered from 0 to {@link #count} - 1. */
    public int material(int number) {
        return materials[number];
    }

    /** The index of a triangle that is a face of the material with this number. */
    public int triangle(int number) {
        return triangles[number];
    }

    private int faces(int number) {
        return (halves[number] + 1) / 2;
    }

    /** Whether a path that is inside the given solids enters a solid or a sheet of this material at these faces. */
    public boolean begins(int number, EnteredSolids solids) {
        return faces(number) > solids.faces(materials[number]);
    }

    /**
     * Updates the solids that a path is inside as it crosses all of these faces: the path leaves the solids that end at
     * the faces, and enters those that begin there.
     */
    public void pass(EnteredSolids solids) {
        for (int i = 0; i < count; i++) {
            int left = solids.faces(materials[i]);
            solids.leave(materials[i]);
            if (faces(i) > left && !surfaces.isSheet(materials[i])) {
                solids.enter(materials[i], faces(i) - left);
            }
        }
    }

    /**
     * The distance along the path from the point to the last of these faces, as a multiple of the length of the given
     * direction.
     */
    public double beyond() {
        return beyond;
    }
}
