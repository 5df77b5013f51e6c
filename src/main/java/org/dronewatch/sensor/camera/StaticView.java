package org.dronewatch.sensor.camera;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.world.World;

/**
 * What a camera sees of the world without drones: a distance for each pixel, traced when it is first asked for and kept.
 * Used by one thread at a time.
 */
final class StaticView {
    private final CameraObject camera;
    private final World world;
    private final KDTraversal traversal;
    private final double[] direction = new double[3];

    /** Distance along each pixel's ray, m; infinity for none; not a number where it has not been traced yet. */
    private final float[] distances;

    StaticView(CameraObject camera, World world) {
        this.camera = camera;
        this.world = world;
        this.traversal = world.newTraversal();
        this.distances = new float[camera.width() * camera.height()];
        Arrays.fill(distances, Float.NaN);
    }

    /** Whether this view shows a world. */
    boolean shows(World other) {
        return world == other;
    }

    /** Distance along a pixel's ray to the world, m; infinity for none. */
    float distance(int column, int row) {
        int pixel = row * camera.width() + column;
        float known = distances[pixel];
        if (Float.isNaN(known)) {
            known = trace(column, row, traversal, direction);
            distances[pixel] = known;
        }
        return known;
    }

    /** Traces all that has not been traced yet, on so many threads, and gives a copy of all distances, row by row. */
    float[] all(int threads) {
        AtomicInteger nextRow = new AtomicInteger();
        Runnable rows = () -> {
            KDTraversal own = world.newTraversal();
            double[] ownDirection = new double[3];
            for (int row = nextRow.getAndIncrement(); row < camera.height(); row = nextRow.getAndIncrement()) {
                traceRow(row, own, ownDirection);
            }
        };
        Helpers.runOnThreads(rows, threads);
        return distances.clone();
    }

    private void traceRow(int row, KDTraversal own, double[] ownDirection) {
        int start = row * camera.width();
        for (int column = 0; column < camera.width(); column++) {
            if (Float.isNaN(distances[start + column])) {
                distances[start + column] = trace(column, row, own, ownDirection);
            }
        }
    }

    private float trace(int column, int row, KDTraversal own, double[] ownDirection) {
        camera.direction(column, row, ownDirection);
        Position from = camera.position();
        boolean hit = own.closestHit(
                from.x(),
                from.y(),
                from.z(),
                ownDirection[0],
                ownDirection[1],
                ownDirection[2],
                0.0,
                Double.POSITIVE_INFINITY);
        return hit ? (float) own.distance() : Float.POSITIVE_INFINITY;
    }
}
