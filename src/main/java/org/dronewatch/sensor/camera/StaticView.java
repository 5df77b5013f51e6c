package org.dronewatch.sensor.camera;

import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.TileTraversal;
import org.dronewatch.parallel.Workers;
import org.dronewatch.world.World;

/**
 * What a camera sees of the world without drones: a distance for each pixel, traced tile by tile when one of the tile's
 * pixels is first asked for, and kept. Used by one thread at a time.
 */
final class StaticView {
    private static final int TILE_WIDTH = TileTraversal.WIDTH;
    private static final int TILE_HEIGHT = TileTraversal.HEIGHT;

    private final CameraObject camera;
    private final World world;
    private final TileTraversal traversal;

    private final int tilesAcross;

    /** Distance along each pixel's ray, m; infinity for none. */
    private final float[] distances;

    /** Which tiles hold their distances already. */
    private final boolean[] traced;

    StaticView(CameraObject camera, World world) {
        this.camera = camera;
        this.world = world;
        this.traversal = newTraversal();
        this.tilesAcross = (camera.width() + TILE_WIDTH - 1) / TILE_WIDTH;
        this.distances = new float[camera.width() * camera.height()];
        this.traced = new boolean[tilesAcross * ((camera.height() + TILE_HEIGHT - 1) / TILE_HEIGHT)];
    }

    private TileTraversal newTraversal() {
        TileTraversal created = new TileTraversal(world.tree());
        Position from = camera.position();
        double[][] grid = camera.grid();
        created.setPicture(new double[] {from.x(), from.y(), from.z()}, grid[0], grid[1], grid[2]);
        return created;
    }

    /** Whether this view shows a world. */
    boolean shows(World other) {
        return world == other;
    }

    /** Distance along a pixel's ray to the world, m; infinity for none. */
    float distance(int column, int row) {
        int tile = row / TILE_HEIGHT * tilesAcross + column / TILE_WIDTH;
        if (!traced[tile]) {
            trace(traversal, tile);
        }
        return distances[row * camera.width() + column];
    }

    /** Traces all that has not been traced yet, on the threads at hand, and gives a copy of all distances, row by row. */
    float[] all() {
        Workers.forEach(traced.length, this::newTraversal, (own, tile) -> {
            if (!traced[tile]) {
                trace(own, tile);
            }
        });
        return distances.clone();
    }

    private void trace(TileTraversal own, int tile) {
        int left = tile % tilesAcross * TILE_WIDTH;
        int top = tile / tilesAcross * TILE_HEIGHT;
        own.trace(left, top, Math.min(TILE_WIDTH, camera.width() - left), Math.min(TILE_HEIGHT, camera.height() - top));
        own.copyDistances(distances, camera.width());
        traced[tile] = true;
    }
}
