package org.dronewatch.sensor.optics;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntPredicate;
import java.util.stream.Stream;
import org.dronewatch.drone.Drone;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.raster.TileTracer;
import org.jogamp.vecmath.Matrix4d;

/**
 * The drones in one frame over a static view: for each drone, only its significant pixels are traced, against its own
 * tree, with the ray moved into its model space. Directions are not normalised again there, so that distances can be
 * compared. Each pixel belongs to the nearest drone that is in front of the world. For use by one thread at a time.
 */
final class DynamicView {
    /**
     * A drone with more triangles than this for each pixel of its rectangle is traced ray by ray. Measured with the
     * quadrotor of 4,904 triangles: at 24 x 24 pixels, rays and tiles take the same time; at 12 x 12 pixels, rays take
     * half as long as tiles.
     */
    private static final double TRIANGLES_PER_PIXEL = 6.0;

    /** Width and height, pixels, of the tile in the middle of a large drone that is drawn first. */
    private static final int MIDDLE = 8;

    private final CameraObject camera;
    private final SignificantPixels significantPixels;
    private final Matrix4d toModel = new Matrix4d();
    private final ModelGrid grid;

    /** The rectangle around a drone that is not drawn, or of which only some pixels are traced. */
    private final PixelRectangle around = new PixelRectangle();

    /** The tracer of the drone whose pixels are traced one by one. */
    private TileTracer singly;

    private final Function<KDTree, TileTracer> tracers;
    private final Map<KDTree, TileTracer> traversals;

    /** One silhouette for each drone of the last frame, in the order of that frame. */
    private Silhouette[] silhouettes = new Silhouette[0];

    /**
     * The silhouettes in front of the drone that is being drawn which may overlap with it in the image: only a few of a
     * large swarm.
     */
    private Silhouette[] rivals = new Silhouette[0];

    private int rivalCount;

    /**
     * A view without drones.
     *
     * @param tracers creates the tracer of a drone's tree
     */
    DynamicView(CameraObject camera, Function<KDTree, TileTracer> tracers) {
        this(camera, tracers, new IdentityHashMap<>());
    }

    private DynamicView(CameraObject camera, Function<KDTree, TileTracer> tracers, Map<KDTree, TileTracer> traversals) {
        this.camera = camera;
        this.tracers = tracers;
        this.traversals = traversals;
        this.significantPixels = new SignificantPixels(camera);
        this.grid = new ModelGrid(camera);
    }

    /**
     * A view of a camera in another pose, which takes over the tracers, since they hold much memory; this view must not
     * be used afterwards.
     */
    DynamicView turned(CameraObject to) {
        return new DynamicView(to, tracers, traversals);
    }

    /** Draws the drones of a new frame and forgets those of the last. */
    void draw(Background background, List<Drone> drones) {
        draw(background, drones, pixels -> false);
    }

    /**
     * Draws a drone alone and forgets those of the last frame.
     *
     * @param enough whether a number of its pixels is sufficient; drawing stops there
     */
    void draw(Background background, Drone drone, IntPredicate enough) {
        draw(background, List.of(drone), enough);
    }

    private void draw(Background background, List<Drone> drones, IntPredicate enough) {
        int count = drones.size();
        if (silhouettes.length != count) {
            silhouettes = Stream.generate(Silhouette::new).limit(count).toArray(Silhouette[]::new);
            rivals = new Silhouette[count];
        }
        for (int i = 0; i < count; i++) {
            significantPixels.find(drones.get(i), silhouettes[i].rectangle());
            silhouettes[i].clear();
            if (!silhouettes[i].rectangle().isEmpty()) {
                findRivals(i);
                draw(background, drones.get(i), i, enough);
            }
        }
    }

    private void findRivals(int number) {
        rivalCount = 0;
        for (int i = 0; i < number; i++) {
            if (silhouettes[i].overlaps(silhouettes[number])) {
                rivals[rivalCount++] = silhouettes[i];
            }
        }
    }

    private void draw(Background background, Drone drone, int number, IntPredicate enough) {
        PixelRectangle rectangle = silhouettes[number].rectangle();
        TileTracer traversal = aim(drone);
        int asked = 1;
        boolean coarse = isCoarse(drone, rectangle);
        if (coarse && isEnoughInTheMiddle(traversal, background, number, enough)) {
            return;
        }
        int tileRows = tiles(rectangle.top(), rectangle.bottom(), TileTracer.HEIGHT);
        int tileColumns = tiles(rectangle.left(), rectangle.right(), TileTracer.WIDTH);
        for (int i = 0; i < tileRows * tileColumns; i++) {
            int top = rectangle.top() + TileTracer.HEIGHT * fromMiddle(i / tileColumns, tileRows);
            int left = rectangle.left() + TileTracer.WIDTH * fromMiddle(i % tileColumns, tileColumns);
            int rows = Math.min(TileTracer.HEIGHT, rectangle.bottom() + 1 - top);
            int columns = Math.min(TileTracer.WIDTH, rectangle.right() + 1 - left);
            if (coarse) {
                traversal.trace(left, top, columns, rows);
            } else {
                traversal.traceSingly(left, top, columns, rows);
            }
            claimTile(traversal, left, top, columns, rows, background, number);
            int pixels = silhouettes[number].pixels();
            if (pixels >= asked) {
                if (enough.test(pixels)) {
                    return;
                }
                asked = 2 * pixels;
            }
        }
    }

    private static int tiles(int first, int last, int size) {
        return (last - first) / size + 1;
    }

    /** The number of a tile in the order from the middle outwards: the body of a drone is in the middle. */
    private static int fromMiddle(int number, int tiles) {
        return tiles / 2 + (number % 2 == 0 ? number : -number - 1) / 2;
    }

    /**
     * Draws the middle of a large drone if that is enough, and returns whether it is; otherwise draws nothing.
     *
     * @param enough whether a number of pixels is sufficient; false for every number if all pixels are needed
     */
    private boolean isEnoughInTheMiddle(TileTracer traversal, Background background, int number, IntPredicate enough) {
        PixelRectangle rectangle = silhouettes[number].rectangle();
        if (rectangle.pixels() <= 2 * MIDDLE * MIDDLE || !enough.test(MIDDLE * MIDDLE)) {
            return false;
        }
        int columns = Math.min(MIDDLE, rectangle.right() + 1 - rectangle.left());
        int rows = Math.min(MIDDLE, rectangle.bottom() + 1 - rectangle.top());
        int left = (rectangle.left() + rectangle.right() + 1 - columns) / 2;
        int top = (rectangle.top() + rectangle.bottom() + 1 - rows) / 2;
        traversal.trace(left, top, columns, rows);
        claimTile(traversal, left, top, columns, rows, background, number);
        boolean isEnough = enough.test(silhouettes[number].pixels());
        if (!isEnough) {
            silhouettes[number].clear();
        }
        return isEnough;
    }

    private TileTracer aim(Drone drone) {
        TileTracer traversal = traversals.computeIfAbsent(drone.tree(), tracers);
        drone.worldToModel(toModel);
        grid.setPicture(traversal, toModel);
        return traversal;
    }

    /** Whether tiles are faster than rays. */
    private static boolean isCoarse(Drone drone, PixelRectangle rectangle) {
        return isCoarse(drone, rectangle.pixels());
    }

    private static boolean isCoarse(Drone drone, int pixels) {
        return drone.tree().mesh().triangleCount() < TRIANGLES_PER_PIXEL * pixels;
    }

    /**
     * Prepares to trace some pixels of a drone one by one; what was drawn before is kept.
     *
     * @param pixels number of pixels that may be traced
     * @return false if it is faster to draw the drone by tiles
     */
    boolean beginSingly(Drone drone, int pixels) {
        significantPixels.find(drone, around);
        if (isCoarse(drone, Math.min(pixels, around.isEmpty() ? 0 : around.pixels()))) {
            return false;
        }
        singly = around.isEmpty() ? null : aim(drone);
        return true;
    }

    /**
     * Distance of that drone along the ray of a pixel, as if it were drawn, m; infinity where the ray does not meet the
     * drone.
     */
    float distanceSingly(int column, int row) {
        if (!around.contains(column, row)) {
            return Float.POSITIVE_INFINITY;
        }
        singly.traceSingly(column, row, 1, 1);
        return singly.hits(0, 0)
                ? (float) (singly.parameter(0, 0) * camera.obliqueness(column, row))
                : Float.POSITIVE_INFINITY;
    }

    private void claimTile(
            TileTracer traversal, int left, int top, int columns, int rows, Background background, int number) {
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                if (traversal.hits(column, row)) {
                    double distance = traversal.parameter(column, row) * camera.obliqueness(left + column, top + row);
                    claim(left + column, top + row, (float) distance, background, number);
                }
            }
        }
    }

    /** Gives a pixel to a drone that is in front of the world and of all drones that were drawn before it. */
    private void claim(int column, int row, float distance, Background background, int number) {
        if (!(distance < background.distance(column, row))) {
            return;
        }
        for (int i = 0; i < rivalCount; i++) {
            float other = rivals[i].distance(column, row);
            if (other <= distance) {
                return;
            }
            if (other < Float.POSITIVE_INFINITY) {
                rivals[i].hide(column, row);
            }
        }
        silhouettes[number].show(column, row, distance);
    }

    /** The number of pixels that can show a drone: those of the rectangle around it. */
    int mostPixels(Drone drone) {
        significantPixels.find(drone, around);
        return around.isEmpty() ? 0 : around.pixels();
    }

    /** The number of pixels that show a drone, by its index in the list that was drawn. */
    int pixels(int number) {
        return silhouettes[number].pixels();
    }

    /** A copy of the pixels of a drone, by its index in the list that was drawn. */
    DronePixels pixels(int number, String id) {
        return new DronePixels(id, silhouettes[number]);
    }

    /** Draws the drones over an image's distances and marks their pixels. */
    void overlay(float[] distances, boolean[] hits) {
        for (Silhouette silhouette : silhouettes) {
            PixelRectangle rectangle = silhouette.rectangle();
            for (int row = rectangle.top(); row <= rectangle.bottom(); row++) {
                for (int column = rectangle.left(); column <= rectangle.right(); column++) {
                    float distance = silhouette.distance(column, row);
                    if (distance < Float.POSITIVE_INFINITY) {
                        int pixel = row * camera.width() + column;
                        distances[pixel] = distance;
                        hits[pixel] = true;
                    }
                }
            }
        }
    }
}
