package org.dronewatch.sensor.camera;

import java.util.Arrays;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.world.Drone;
import org.jogamp.vecmath.Matrix4d;

/**
 * The drones in one frame over a static view: for each drone, only its significant pixels are traced, against its own
 * tree, with the ray moved into its model space. Directions are not made unit again there, so distances compare. Each
 * pixel belongs to the nearest drone that stands before the world. Used by one thread at a time.
 */
final class DynamicView {
    private static final int NOBODY = -1;

    private final CameraObject camera;
    private final SignificantPixels significantPixels;
    private final double[] direction = new double[3];

    /** For each pixel with a drone: how far it is, and which one. Only the last frame's rectangles hold anything. */
    private final float[] nearest;

    private final int[] owner;
    private PixelRectangle[] rectangles = new PixelRectangle[0];
    private int[] pixelCounts = new int[0];
    private KDTraversal[] traversals = new KDTraversal[0];
    private KDTree[] traversed = new KDTree[0];

    DynamicView(CameraObject camera) {
        this.camera = camera;
        this.significantPixels = new SignificantPixels(camera);
        this.nearest = new float[camera.width() * camera.height()];
        this.owner = new int[nearest.length];
        Arrays.fill(nearest, Float.POSITIVE_INFINITY);
        Arrays.fill(owner, NOBODY);
    }

    /** Draws the drones of a new frame and forgets those of the last. */
    void draw(StaticView staticView, List<Drone> drones) {
        for (PixelRectangle rectangle : rectangles) {
            clear(rectangle);
        }
        int count = drones.size();
        if (rectangles.length != count) {
            rectangles = new PixelRectangle[count];
            pixelCounts = new int[count];
            traversals = new KDTraversal[count];
            traversed = new KDTree[count];
        }
        Arrays.fill(pixelCounts, 0);
        for (int i = 0; i < count; i++) {
            rectangles[i] = significantPixels.of(drones.get(i));
            if (!rectangles[i].isEmpty()) {
                draw(staticView, drones.get(i), i);
            }
        }
    }

    private void draw(StaticView staticView, Drone drone, int number) {
        PixelRectangle rectangle = rectangles[number];
        KDTraversal traversal = traversalOf(drone, number);
        Matrix4d m = drone.worldToModel();
        Position from = camera.position();
        double x = m.m00 * from.x() + m.m01 * from.y() + m.m02 * from.z() + m.m03;
        double y = m.m10 * from.x() + m.m11 * from.y() + m.m12 * from.z() + m.m13;
        double z = m.m20 * from.x() + m.m21 * from.y() + m.m22 * from.z() + m.m23;
        for (int row = rectangle.top(); row <= rectangle.bottom(); row++) {
            for (int column = rectangle.left(); column <= rectangle.right(); column++) {
                camera.direction(column, row, direction);
                double dx = m.m00 * direction[0] + m.m01 * direction[1] + m.m02 * direction[2];
                double dy = m.m10 * direction[0] + m.m11 * direction[1] + m.m12 * direction[2];
                double dz = m.m20 * direction[0] + m.m21 * direction[1] + m.m22 * direction[2];
                if (traversal.closestHit(x, y, z, dx, dy, dz, 0.0, Double.POSITIVE_INFINITY)) {
                    claim(column, row, (float) traversal.distance(), staticView, number);
                }
            }
        }
    }

    private void claim(int column, int row, float distance, StaticView staticView, int number) {
        int pixel = row * camera.width() + column;
        if (distance < nearest[pixel] && distance < staticView.distance(column, row)) {
            if (owner[pixel] != NOBODY) {
                pixelCounts[owner[pixel]]--;
            }
            owner[pixel] = number;
            nearest[pixel] = distance;
            pixelCounts[number]++;
        }
    }

    private KDTraversal traversalOf(Drone drone, int number) {
        if (traversed[number] != drone.tree()) {
            traversed[number] = drone.tree();
            traversals[number] = drone.tree().newTraversal();
        }
        return traversals[number];
    }

    private void clear(PixelRectangle rectangle) {
        for (int row = rectangle.top(); row <= rectangle.bottom(); row++) {
            int start = row * camera.width();
            Arrays.fill(nearest, start + rectangle.left(), start + rectangle.right() + 1, Float.POSITIVE_INFINITY);
            Arrays.fill(owner, start + rectangle.left(), start + rectangle.right() + 1, NOBODY);
        }
    }

    /** How many pixels show the drone of a number in the list that was drawn. */
    int pixels(int number) {
        return pixelCounts[number];
    }

    /** Puts the drones over a picture's distances and marks their pixels. */
    void overlay(float[] distances, boolean[] hits) {
        for (PixelRectangle rectangle : rectangles) {
            for (int row = rectangle.top(); row <= rectangle.bottom(); row++) {
                for (int column = rectangle.left(); column <= rectangle.right(); column++) {
                    int pixel = row * camera.width() + column;
                    if (owner[pixel] != NOBODY) {
                        distances[pixel] = nearest[pixel];
                        hits[pixel] = true;
                    }
                }
            }
        }
    }
}
