package org.dronewatch.sensor.optics;

import java.util.concurrent.atomic.AtomicReferenceArray;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.raster.TileTracer;
import org.dronewatch.world.World;

/**
 * What a camera sees of the world without drones: a distance for each pixel, traced tile by tile when one of the tile's
 * pixels is first requested, and kept. Used by one thread at a time.
 */
final class StaticView implements Background {
    /** Smaller than the tiles that a traversal allows: mostly only the few pixels behind a drone are requested. */
    private static final int TILE_WIDTH = 32;

    private static final int TILE_HEIGHT = 32;

    private final CameraObject camera;
    private final World world;
    private final TileTracer traversal;

    private final int tilesAcross;

    /** The distances of each tile, m, row by row; infinity for none. None for a tile that has not been traced yet. */
    private final AtomicReferenceArray<float[]> tiles;

    /**
     * A view of a world.
     *
     * @param image keeps the tiles; views of the same camera may share it
     */
    StaticView(CameraObject camera, World world, SiteImage image) {
        this.camera = camera;
        this.world = world;
        this.traversal = newTraversal();
        this.tilesAcross = (camera.width() + TILE_WIDTH - 1) / TILE_WIDTH;
        this.tiles = image.of(world, tilesAcross * ((camera.height() + TILE_HEIGHT - 1) / TILE_HEIGHT));
    }

    private TileTracer newTraversal() {
        TileTracer created = world.newTileTracer(world.tree());
        Position from = camera.position();
        double[][] grid = camera.grid();
        created.setPicture(
                new double[] {from.x(), from.y(), from.z()}, grid[0], grid[1], grid[2], camera.near(), camera.far());
        return created;
    }

    /** Whether this view shows a world. */
    boolean shows(World other) {
        return world == other;
    }

    /** Distance along a pixel's ray to the world, m; infinity for none. */
    @Override
    public float distance(int column, int row) {
        int tile = row / TILE_HEIGHT * tilesAcross + column / TILE_WIDTH;
        float[] distances = tiles.get(tile);
        if (distances == null) {
            distances = trace(traversal, tile);
            tiles.set(tile, distances);
        }
        int left = tile % tilesAcross * TILE_WIDTH;
        return distances[row % TILE_HEIGHT * columns(left) + column - left];
    }

    /**
     * Traces everything that has not been traced yet, on the available threads, and returns all distances, row by row.
     */
    float[] all() {
        float[] distances = new float[camera.width() * camera.height()];
        Workers.forEach(tiles.length(), this::newTraversal, (own, tile) -> {
            if (tiles.get(tile) == null) {
                tiles.set(tile, trace(own, tile));
            }
            copy(tile, distances);
        });
        return distances;
    }

    private float[] trace(TileTracer own, int tile) {
        int left = tile % tilesAcross * TILE_WIDTH;
        int top = tile / tilesAcross * TILE_HEIGHT;
        int columns = columns(left);
        int rows = Math.min(TILE_HEIGHT, camera.height() - top);
        float[] distances = new float[columns * rows];
        own.trace(left, top, columns, rows);
        own.copyDistances(distances, 0, columns);
        return distances;
    }

    private int columns(int left) {
        return Math.min(TILE_WIDTH, camera.width() - left);
    }

    private void copy(int tile, float[] target) {
        int left = tile % tilesAcross * TILE_WIDTH;
        int top = tile / tilesAcross * TILE_HEIGHT;
        int columns = columns(left);
        float[] source = tiles.get(tile);
        for (int row = 0; row < source.length / columns; row++) {
            System.arraycopy(source, row * columns, target, (top + row) * camera.width() + left, columns);
        }
    }
}
