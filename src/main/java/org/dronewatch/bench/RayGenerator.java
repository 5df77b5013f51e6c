package org.dronewatch.bench;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Triangle;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;

/**
 * Generates rays for the benchmark of a model if no ray file is given: the rays of a camera inside the model's box,
 * aimed at the middle of the box, and diffuse reflections of these rays.
 */
public final class RayGenerator {
    private static final int WIDTH = 1024;
    private static final int HEIGHT = 768;
    /** Where the eye is, from the box's middle, as a fraction of the box. */
    private static final double[] EYE = {0.35, 0.30, 0.32};

    private static final int DIFFUSE_RAYS = 1_000_000;
    private static final int MAX_BOUNCES = 10;
    private static final int MAX_PATHS_PER_RAY = 50;
    /** How far a reflected ray starts above its surface, as a fraction of the box's diagonal. */
    private static final double OFFSET = 1e-5;

    private final KDTree tree;
    private final long seed;
    private final Vector3d up;

    /**
     * A generator of rays for the tree of a model in its file's coordinates, y up; the same seed gives the same rays.
     */
    public RayGenerator(KDTree tree, long seed) {
        this(tree, seed, new Vector3d(0, 1, 0));
    }

    /** A generator of rays for a tree, with the unit direction that is upwards in pictures. */
    RayGenerator(KDTree tree, long seed, Vector3d up) {
        this.tree = tree;
        this.seed = seed;
        this.up = up;
    }

    /** The rays of a picture of 1024 x 768 pixels with a horizontal field of view of 90 degrees. */
    public RaySet camera() {
        return camera(WIDTH, HEIGHT);
    }

    /** The rays of a picture of a given size in pixels with a horizontal field of view of 90 degrees. */
    public RaySet camera(int width, int height) {
        AABB box = tree.bounds();
        Point3d center = box.center();
        Point3d eye = new Point3d(
                center.x + EYE[0] * (box.maxX() - box.minX()),
                center.y + EYE[1] * (box.maxY() - box.minY()),
                center.z + EYE[2] * (box.maxZ() - box.minZ()));
        Vector3d forward = new Vector3d(center);
        forward.sub(eye);
        forward.normalize();
        Vector3d right = new Vector3d();
        right.cross(forward, Math.abs(forward.dot(up)) < 0.99 ? up : new Vector3d(up.z, up.x, up.y));
        right.normalize();
        Vector3d upwards = new Vector3d();
        upwards.cross(right, forward);

        float[] rays = new float[width * height * RaySet.FLOATS];
        for (int pixel = 0; pixel < width * height; pixel++) {
            int row = pixel / width;
            double x = 2.0 * (pixel % width + 0.5) / width - 1.0;
            double y = (height - 2.0 * (row + 0.5)) / width;
            Vector3d direction = new Vector3d(forward);
            direction.scaleAdd(x, right, direction);
            direction.scaleAdd(y, upwards, direction);
            put(rays, pixel, eye, direction);
        }
        return new RaySet("camera", rays, width);
    }

    /**
     * A million rays of paths that start where the camera's rays hit and are reflected up to ten times, each in a
     * direction drawn by Lambert's cosine law. Empty if none of the camera's rays hits anything.
     */
    public RaySet diffuse(RaySet camera) {
        return diffuse(camera, DIFFUSE_RAYS);
    }

    RaySet diffuse(RaySet camera, int count) {
        SplittableRandom random = new SplittableRandom(seed);
        float[] rays = new float[count * RaySet.FLOATS];
        RayTracer traversal = new StackTraversal(tree);
        int made = 0;
        for (int path = 0; path < MAX_PATHS_PER_RAY * count && made < count; path++) {
            int start = random.nextInt(camera.count()) * RaySet.FLOATS;
            float[] current = Arrays.copyOfRange(camera.rays(), start, start + RaySet.FLOATS);
            for (int bounce = 0; bounce < MAX_BOUNCES && made < count && hits(traversal, current); bounce++) {
                bounce(traversal, current, random);
                System.arraycopy(current, 0, rays, made * RaySet.FLOATS, RaySet.FLOATS);
                made++;
            }
        }
        return new RaySet("diffuse", Arrays.copyOf(rays, made * RaySet.FLOATS), 0);
    }

    private static boolean hits(RayTracer traversal, float[] r) {
        return traversal.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], 0.0, Double.POSITIVE_INFINITY);
    }

    /** Replaces a ray by one that leaves the surface it hit. */
    private void bounce(RayTracer traversal, float[] ray, SplittableRandom random) {
        Triangle triangle = tree.mesh().triangle(traversal.triangle());
        Vector3d normal = triangle.areaNormal();
        normal.normalize();
        Vector3d incoming = new Vector3d(ray[3], ray[4], ray[5]);
        if (normal.dot(incoming) > 0.0) {
            normal.negate();
        }
        Point3d origin = new Point3d(ray[0], ray[1], ray[2]);
        origin.scaleAdd(traversal.distance(), incoming, origin);
        origin.scaleAdd(OFFSET * tree.bounds().diagonal(), normal, origin);

        // The normal plus a uniform point of the unit sphere is distributed as the cosine.
        double z = 1.0 - 2.0 * random.nextDouble();
        double angle = 2.0 * Math.PI * random.nextDouble();
        double radius = Math.sqrt(Math.max(0.0, 1.0 - z * z));
        Vector3d direction = new Vector3d(radius * Math.cos(angle), radius * Math.sin(angle), z);
        direction.add(normal);
        put(ray, 0, origin, direction.lengthSquared() > 1e-12 ? direction : normal);
    }

    private static void put(float[] rays, int index, Point3d origin, Vector3d direction) {
        Vector3d unit = new Vector3d(direction);
        unit.normalize();
        int start = index * RaySet.FLOATS;
        rays[start] = (float) origin.x;
        rays[start + 1] = (float) origin.y;
        rays[start + 2] = (float) origin.z;
        rays[start + 3] = (float) unit.x;
        rays[start + 4] = (float) unit.y;
        rays[start + 5] = (float) unit.z;
    }
}
