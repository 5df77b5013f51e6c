package org.dronewatch.render;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.BooleanSupplier;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.parallel.Workers;
import org.dronewatch.raster.TileTracer;
import org.dronewatch.render.canvas.Canvas;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.world.World;

/**
 * Paints the site, traced as cameras trace it, in tiles on the available threads. Where the site is cut open, rays go
 * one by one, from the cut or up to it; walls that the cut goes through show as dark sections. One picture at a time.
 */
final class SitePainter {
    private static final int SECTION = 0x4a4640;
    private static final int DRONE = 0xe8501e;
    private static final int BIRD = 0x7a828f;

    /** How far off a surface the ray to the sun begins, as a fraction of the distance of the surface. */
    private static final double OFF = 2e-5;

    /** Maximum number of back faces skipped. */
    private static final int MOST_BACKS = 8;

    /** Block size for shared shadow tests, pixels. */
    private static final int BLOCK = 2;

    private final KDTree tree;
    private final Facets facets;
    private final Queue<Brush> brushes = new ConcurrentLinkedQueue<>();

    SitePainter(World world, Map<String, Integer> colours) {
        this.tree = world.tree();
        this.facets = new Facets(world, colours);
    }

    /** The appearance of the site's triangles. */
    Facets facets() {
        return facets;
    }

    /** The buffers of one painting thread. */
    private final class Brush {
        private final TileTracer tiles = new TileTracer(tree);
        private final RayTracer single = new StackTraversal(tree);
        private final double[] direction = new double[3];

        /** Depth and triangle of what a single ray found. */
        private final double[] found = new double[2];

        /** Whether the sun was seen in each block of the tile: 0 not tested, 1 seen, 2 not seen. */
        private final byte[] sun = new byte[TileTracer.WIDTH / BLOCK * (TileTracer.HEIGHT / BLOCK)];
    }

    /** What does not change from pixel to pixel. */
    private record Shot(CameraObject camera, double[] eye, double[][] grid, Cut cut, boolean shadows, Canvas canvas) {}

    /**
     * Paints the world and the sky.
     *
     * @param cut clipping plane, or null for none
     * @param shadows whether surfaces are tested for the sun's shadows, which is about as much work again as single
     *     rays
     * @param abandoned queried before each tile: once it is true, the rest stays unpainted
     */
    void paint(CameraObject camera, Cut cut, boolean shadows, Canvas canvas, BooleanSupplier abandoned) {
        Position from = camera.position();
        double[] eye = {from.x(), from.y(), from.z()};
        Shot shot = new Shot(camera, eye, camera.grid(), cut, shadows, canvas);
        int across = (canvas.width + TileTracer.WIDTH - 1) / TileTracer.WIDTH;
        int down = (canvas.height + TileTracer.HEIGHT - 1) / TileTracer.HEIGHT;
        Queue<Brush> used = new ConcurrentLinkedQueue<>();
        Workers.forEach(across * down, () -> take(shot, used), (brush, tile) -> {
            if (!abandoned.getAsBoolean()) {
                paintTile(shot, brush, tile % across * TileTracer.WIDTH, tile / across * TileTracer.HEIGHT);
            }
        });
        brushes.addAll(used);
    }

    private Brush take(Shot shot, Queue<Brush> used) {
        Brush kept = brushes.poll();
        Brush brush = kept == null ? new Brush() : kept;
        used.add(brush);
        double[][] grid = shot.grid();
        brush.tiles.setPicture(shot.eye(), grid[0], grid[1], grid[2]);
        return brush;
    }

    private void paintTile(Shot shot, Brush brush, int left, int top) {
        Canvas canvas = shot.canvas();
        int columns = Math.min(TileTracer.WIDTH, canvas.width - left);
        int rows = Math.min(TileTracer.HEIGHT, canvas.height - top);
        Arrays.fill(brush.sun, (byte) 0);
        if (shot.cut() == null) {
            brush.tiles.trace(left, top, columns, rows);
        }
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                setDirection(shot, brush, left + column, top + row);
                int pixel = (top + row) * canvas.width + left + column;
                boolean hit = shot.cut() == null ? take(canvas, brush, pixel, column, row) : trace(shot, brush, pixel);
                int block = row / BLOCK * (TileTracer.WIDTH / BLOCK) + column / BLOCK;
                canvas.rgb[pixel] = hit ? colour(shot, brush, pixel, block) : sky(brush);
            }
        }
    }

    /** The direction that reaches one metre along the camera's axis: ray parameters are depths. */
    private static void setDirection(Shot shot, Brush brush, int column, int row) {
        for (int axis = 0; axis < 3; axis++) {
            brush.direction[axis] = shot.grid()[0][axis] + column * shot.grid()[1][axis] + row * shot.grid()[2][axis];
        }
    }

    private static boolean take(Canvas canvas, Brush brush, int pixel, int column, int row) {
        if (!brush.tiles.hits(column, row)) {
            canvas.depth[pixel] = Float.POSITIVE_INFINITY;
            canvas.triangle[pixel] = Canvas.NOTHING;
            return false;
        }
        canvas.depth[pixel] = (float) brush.tiles.parameter(column, row);
        canvas.triangle[pixel] = brush.tiles.triangle(column, row);
        return true;
    }

    /** Traces a ray through the unclipped part of the site. */
    private boolean trace(Shot shot, Brush brush, int pixel) {
        double[] eye = shot.eye();
        double[] d = brush.direction;
        double beyond = shot.cut().depth(eye[0], eye[1], eye[2]);
        double rate = shot.cut().rate(d[0], d[1], d[2]);
        double from = 0.0;
        double to = Double.POSITIVE_INFINITY;
        if (beyond > 0.0) {
            from = rate < 0.0 ? -beyond / rate : Double.POSITIVE_INFINITY;
        } else if (rate > 0.0) {
            to = -beyond / rate;
        }
        Canvas canvas = shot.canvas();
        double[] found = brush.found;
        boolean hit = from < to && firstToShow(shot, brush, from, to);
        canvas.depth[pixel] = hit ? (float) found[0] : Float.POSITIVE_INFINITY;
        canvas.triangle[pixel] = hit ? (int) found[1] : Canvas.NOTHING;
        return hit;
    }

    /**
     * The first surface that shows its front, so that the viewer looks into a building that is cut open through the
     * backs of its walls; where the cut goes through something solid, the cut itself.
     */
    private boolean firstToShow(Shot shot, Brush brush, double from, double to) {
        double[] eye = shot.eye();
        double[] d = brush.direction;
        double next = from;
        for (int backs = 0; backs < MOST_BACKS; backs++) {
            if (!brush.single.closestHit(eye[0], eye[1], eye[2], d[0], d[1], d[2], next, to)) {
                return false;
            }
            brush.found[0] = brush.single.distance();
            brush.found[1] = brush.single.triangle();
            if (!showsItsBack(brush, 1.0)) {
                return true;
            }
            if (backs == 0 && from > 0.0 && isInsideSolid(eye, brush, from)) {
                brush.found[0] = from;
                brush.found[1] = Canvas.NOTHING;
                return true;
            }
            next = Math.nextUp(brush.found[0] * (1.0 + 1e-9));
        }
        return true;
    }

    /**
     * Whether a point from which a back is seen ahead lies inside something solid: then a back is also seen in the
     * opposite direction.
     */
    private boolean isInsideSolid(double[] eye, Brush brush, double at) {
        double[] d = brush.direction;
        return brush.single.closestHit(
                        eye[0] + at * d[0],
                        eye[1] + at * d[1],
                        eye[2] + at * d[2],
                        -d[0],
                        -d[1],
                        -d[2],
                        0.0,
                        Double.POSITIVE_INFINITY)
                && showsItsBack(brush, -1.0);
    }

    /** Whether the surface hit last shows its back to a ray that runs ahead (1) or back (-1). */
    private boolean showsItsBack(Brush brush, double sense) {
        int triangle = brush.single.triangle();
        double[] d = brush.direction;
        double facing = facets.normal(triangle, 0) * d[0]
                + facets.normal(triangle, 1) * d[1]
                + facets.normal(triangle, 2) * d[2];
        return sense * facing > 0.0;
    }

    private static int sky(Brush brush) {
        double[] d = brush.direction;
        return DaylightShading.sky(d[2] / Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
    }

    private int colour(Shot shot, Brush brush, int pixel, int block) {
        int triangle = shot.canvas().triangle[pixel];
        if (triangle == Canvas.NOTHING) {
            return SECTION;
        }
        double[] d = brush.direction;
        double scale = 1.0 / Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        double nx = facets.normal(triangle, 0);
        double ny = facets.normal(triangle, 1);
        double nz = facets.normal(triangle, 2);
        double sun = 1.0;
        if (shot.shadows() && DaylightShading.isTurnedToSun(nx, ny, nz, d[0], d[1], d[2])) {
            if (brush.sun[block] == 0) {
                brush.sun[block] = (byte) (seesSun(shot, brush, shot.canvas().depth[pixel]) ? 1 : 2);
            }
            sun = brush.sun[block] == 1 ? 1.0 : 0.0;
        }
        double depth = shot.canvas().depth[pixel];
        int colour = facets.colour(triangle, shot.eye()[0] + depth * d[0], shot.eye()[1] + depth * d[1]);
        return DaylightShading.shade(colour, nx, ny, nz, scale * d[0], scale * d[1], scale * d[2], sun);
    }

    private boolean seesSun(Shot shot, Brush brush, double depth) {
        double[] eye = shot.eye();
        double[] d = brush.direction;
        double near = depth * (1.0 - OFF);
        double x = eye[0] + near * d[0];
        double y = eye[1] + near * d[1];
        double z = eye[2] + near * d[2];
        double to = Double.POSITIVE_INFINITY;
        if (shot.cut() != null) {
            double rate = shot.cut().rate(DaylightShading.SUN_X, DaylightShading.SUN_Y, DaylightShading.SUN_Z);
            to = rate > 0.0 ? Math.max(0.0, -shot.cut().depth(x, y, z) / rate) : to;
        }
        return !brush.single.isOccluded(
                x, y, z, DaylightShading.SUN_X, DaylightShading.SUN_Y, DaylightShading.SUN_Z, OFF * depth, to);
    }

    /** Draws the lines where surfaces end or bend, as a draughtsman would. */
    void outline(Canvas canvas, double focalLength) {
        Workers.forEach(Math.max(0, canvas.height - 2), row -> {
            for (int column = 1; column < canvas.width - 1; column++) {
                int pixel = (row + 1) * canvas.width + column;
                if (isEdge(canvas, pixel, 1, focalLength) || isEdge(canvas, pixel, canvas.width, focalLength)) {
                    canvas.blend(pixel, 0x1c2026, 0.42);
                }
            }
        });
    }

    /** On a plane 1/depth is linear across the picture: where it is not, something ends, or two planes meet. */
    private boolean isEdge(Canvas canvas, int pixel, int step, double focalLength) {
        float here = canvas.depth[pixel];
        if (here == Float.POSITIVE_INFINITY) {
            return false;
        }
        double bend = 1.0 / canvas.depth[pixel - step] + 1.0 / canvas.depth[pixel + step] - 2.0 / here;
        // Only on the nearer side: a line of one pixel.
        if (-bend * here > 8.0 / focalLength) {
            return true;
        }
        int one = canvas.triangle[pixel];
        int other = canvas.triangle[pixel + step];
        return one != other
                && one != Canvas.NOTHING
                && other != Canvas.NOTHING
                && Math.abs(facets.cosine(one, other)) < 0.8;
    }

    /** Paints drones over a canvas that holds the world: where they are in front of it. */
    void paint(CameraObject camera, Cut cut, List<Drone> drones, Canvas canvas) {
        for (Drone drone : drones) {
            if (cut == null || cut.keeps(drone.origin())) {
                new DronePainter(drone, drone.settings().isBird() ? BIRD : DRONE).paint(camera, canvas);
            }
        }
    }
}
