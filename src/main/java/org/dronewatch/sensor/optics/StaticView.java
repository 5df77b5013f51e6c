package org.dronewatch.sensor.optics;

import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.raster.TileTracer;
import org.dronewatch.world.World;

/**
 * A camera's view of the world without drones: a distance for each pixel. A tile is traced when one of its pixels is
 * first requested, and is then kept. For use by one thread at a time.
 */
final class StaticView implements Background {
    /**
     * The width of a tile, smaller than a traversal allows: usually, only the few pixels behind a drone are requested.
     */
    private static final int TILE_WIDTH = 32;

    private static final int TILE_HEIGHT = 32;

    // Where all pixels are requested sooner or later, tracing blocks of tiles takes a third of the time.
    private static final int BLOCK_COLUMNS = TileTracer.WIDTH / TILE_WIDTH;
    private static final int BLOCK_ROWS = TileTracer.HEIGHT / TILE_HEIGHT;

    private final CameraObject camera;
    private final World world;

    /** Created when something is first traced: a camera in a temporary pose often looks at nothing but the drone. */
    private BlockTracer tracer;

    private final SiteImage image;
    private final int tilesAcross;
    private final int tilesDown;
    private final int blocksAcross;

    private boolean tracesBlocks;

    /**
     * A view of a world.
     *
     * @param images keeps the tiles; views of the same camera may share it
     */
    StaticView(CameraObject camera, World world, SiteImages images) {
        this.camera = camera;
        this.world = world;
        this.tilesAcross = (camera.width() + TILE_WIDTH - 1) / TILE_WIDTH;
        this.tilesDown = (camera.height() + TILE_HEIGHT - 1) / TILE_HEIGHT;
        this.blocksAcross = (tilesAcross + BLOCK_COLUMNS - 1) / BLOCK_COLUMNS;
        this.image = images.of(world, tilesAcross * tilesDown);
    }

    /** From now on, most of the image will be requested. */
    void expectAll() {
        tracesBlocks = true;
    }

    private BlockTracer newTracer() {
        TileTracer created = world.newTileTracer(world.tree());
        Position from = camera.position();
        double[][] grid = camera.grid();
        created.setPicture(
                new double[] {from.x(), from.y(), from.z()}, grid[0], grid[1], grid[2], camera.near(), camera.far());
        return new BlockTracer(created, new float[TileTracer.WIDTH * TileTracer.HEIGHT]);
    }

    /** The world that this view shows. */
    World world() {
        return world;
    }

    /** Whether this view shows a world. */
    boolean shows(World other) {
        return world == other;
    }

    /** Distance along a pixel's ray to the world, m; infinity for none. */
    @Override
    public float distance(int column, int row) {
        int tile = row / TILE_HEIGHT * tilesAcross + column / TILE_WIDTH;
        float[] distances = image.tile(tile);
        if (distances == null) {
            distances = traced(tile);
        }
        int left = tile % tilesAcross * TILE_WIDTH;
        return distances[row % TILE_HEIGHT * columns(left) + column - left];
    }

    /**
     * The distances in a tile, traced if necessary. Threads that share the image wait for each other if they need the
     * same part of it.
     */
    private float[] traced(int tile) {
        int block = block(tile);
        synchronized (image.lock(block)) {
            if (image.tile(tile) == null) {
                tracer = tracer == null ? newTracer() : tracer;
                if (tracesBlocks) {
                    traceBlock(tracer, block);
                } else {
                    trace(tracer, tile % tilesAcross, tile / tilesAcross, 1, 1);
                }
            }
            return image.tile(tile);
        }
    }

    private int block(int tile) {
        return tile / tilesAcross / BLOCK_ROWS * blocksAcross + tile % tilesAcross / BLOCK_COLUMNS;
    }

    /**
     * Traces everything that has not been traced yet, on the available threads, and returns all distances, row by row.
     */
    float[] all() {
        float[] distances = new float[camera.width() * camera.height()];
        int blocks = blocksAcross * ((tilesDown + BLOCK_ROWS - 1) / BLOCK_ROWS);
        Workers.forEach(blocks, this::newTracer, this::traceBlock);
        Workers.forEach(image.tiles(), tile -> copy(tile, distances));
        return distances;
    }

    /** Traces a block, unless all of its tiles have been traced. */
    private void traceBlock(BlockTracer own, int block) {
        int column = block % blocksAcross * BLOCK_COLUMNS;
        int row = block / blocksAcross * BLOCK_ROWS;
        int columns = Math.min(BLOCK_COLUMNS, tilesAcross - column);
        int rows = Math.min(BLOCK_ROWS, tilesDown - row);
        boolean isTraced = true;
        for (int i = 0; i < columns * rows; i++) {
            isTraced &= image.tile((row + i / columns) * tilesAcross + column + i % columns) != null;
        }
        if (!isTraced) {
            trace(own, column, row, columns, rows);
        }
    }

    /** Traces neighbouring tiles together. */
    private void trace(BlockTracer own, int column, int row, int tileColumns, int tileRows) {
        int left = column * TILE_WIDTH;
        int top = row * TILE_HEIGHT;
        int width = Math.min(tileColumns * TILE_WIDTH, camera.width() - left);
        int height = Math.min(tileRows * TILE_HEIGHT, camera.height() - top);
        float[] distances = own.distances;
        own.tracer.trace(left, top, width, height);
        own.tracer.copyDistances(distances, 0, width);
        for (int i = 0; i < tileColumns * tileRows; i++) {
            int x = i % tileColumns * TILE_WIDTH;
            int y = i / tileColumns * TILE_HEIGHT;
            int columns = columns(left + x);
            float[] part = new float[columns * Math.min(TILE_HEIGHT, height - y)];
            for (int line = 0; line < part.length / columns; line++) {
                System.arraycopy(distances, (y + line) * width + x, part, line * columns, columns);
            }
            image.put((row + i / tileColumns) * tilesAcross + column + i % tileColumns, part);
        }
    }

    /** The tracer of one thread, with memory for the distances of a block, from which each tile takes its part. */
    private record BlockTracer(TileTracer tracer, float[] distances) {}

    private int columns(int left) {
        return Math.min(TILE_WIDTH, camera.width() - left);
    }

    private void copy(int tile, float[] target) {
        int left = tile % tilesAcross * TILE_WIDTH;
        int top = tile / tilesAcross * TILE_HEIGHT;
        int columns = columns(left);
        float[] source = image.tile(tile);
        for (int row = 0; row < source.length / columns; row++) {
            System.arraycopy(source, row * columns, target, (top + row) * camera.width() + left, columns);
        }
    }
}
