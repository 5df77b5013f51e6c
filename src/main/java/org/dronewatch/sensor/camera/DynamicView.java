package org.dronewatch.sensor.camera;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.TileTraversal;
import org.dronewatch.world.Drone;
import org.jogamp.vecmath.Matrix4d;

/**
 * The drones in one frame over a static view: for each drone, only its significant pixels are traced, against its own
 * tree, with the ray moved into its model space. Directions are not made unit again there, so distances compare. Each
 * pixel belongs to the nearest drone that stands before the world. Used by one thread at a time.
 */
final class DynamicView {
    private static final int NOBODY = -1;
    /** With more triangles than this for each pixel of its rectangle, a drone is traced ray by ray: measured. */
    private static final double TRIANGLES_PER_PIXEL = 0.5;

    private final CameraObject camera;
    private final SignificantPixels significantPixels;
    private final Matrix4d toModel = new Matrix4d();
    private final double[][] grid;
    private final double[] origin = new double[3];
    private final double[][] modelGrid = new double[3][3];

    /** For each pixel with a drone: how far it is, and which one. Only the last frame's rectangles hold anything. */
    private final float[] nearest;

    private final int[] owner;
    private PixelRectangle[] rectangles = new PixelRectangle[0];
    private int[] pixelCounts = new int[0];
    private TileTraversal[] traversals = new TileTraversal[0];
    private KDTree[] traversed = new KDTree[0];

    DynamicView(CameraObject camera) {
        this.camera = camera;
        this.significantPixels = new SignificantPixels(camera);
        this.grid = camera.grid();
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
            rectangles = Stream.generate(PixelRectangle::new).limit(count).toArray(PixelRectangle[]::new);
            pixelCounts = new int[count];
            traversals = new TileTraversal[count];
            traversed = new KDTree[count];
        }
        Arrays.fill(pixelCounts, 0);
        for (int i = 0; i < count; i++) {
            significantPixels.find(drones.get(i), rectangles[i]);
            if (!rectangles[i].isEmpty()) {
                draw(staticView, drones.get(i), i);
            }
        }
    }

    private void draw(StaticView staticView, Drone drone, int number) {
        PixelRectangle rectangle = rectangles[number];
        TileTraversal traversal = traversalOf(drone, number);
        drone.worldToModel(toModel);
        setPicture(traversal, toModel);
        boolean coarse = drone.tree().mesh().triangleCount() < TRIANGLES_PER_PIXEL * rectangle.pixels();
        for (int top = rectangle.top(); top <= rectangle.bottom(); top += TileTraversal.HEIGHT) {
            int rows = Math.min(TileTraversal.HEIGHT, rectangle.bottom() + 1 - top);
            for (int left = rectangle.left(); left <= rectangle.right(); left += TileTraversal.WIDTH) {
                int columns = Math.min(TileTraversal.WIDTH, rectangle.right() + 1 - left);
                if (coarse) {
                    traversal.trace(left, top, columns, rows);
                } else {
                    traversal.traceSingly(left, top, columns, rows);
                }
                claimTile(traversal, left, top, columns, rows, staticView, number);
            }
        }
    }

    /** The grid of the pixels' rays in a drone's model space; lengths along them stay those of the world. */
    private void setPicture(TileTraversal traversal, Matrix4d m) {
        Position from = camera.position();
        origin[0] = m.m00 * from.x() + m.m01 * from.y() + m.m02 * from.z() + m.m03;
        origin[1] = m.m10 * from.x() + m.m11 * from.y() + m.m12 * from.z() + m.m13;
        origin[2] = m.m20 * from.x() + m.m21 * from.y() + m.m22 * from.z() + m.m23;
        for (int i = 0; i < grid.length; i++) {
            double[] d = grid[i];
            modelGrid[i][0] = m.m00 * d[0] + m.m01 * d[1] + m.m02 * d[2];
            modelGrid[i][1] = m.m10 * d[0] + m.m11 * d[1] + m.m12 * d[2];
            modelGrid[i][2] = m.m20 * d[0] + m.m21 * d[1] + m.m22 * d[2];
        }
        traversal.setPicture(origin, modelGrid[0], modelGrid[1], modelGrid[2]);
    }

    private void claimTile(
            TileTraversal traversal, int left, int top, int columns, int rows, StaticView staticView, int number) {
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                if (traversal.hits(column, row)) {
                    double distance = traversal.parameter(column, row) * camera.obliqueness(left + column, top + row);
                    claim(left + column, top + row, (float) distance, staticView, number);
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

    private TileTraversal traversalOf(Drone drone, int number) {
        if (traversed[number] != drone.tree()) {
            traversed[number] = drone.tree();
            traversals[number] = new TileTraversal(drone.tree());
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
