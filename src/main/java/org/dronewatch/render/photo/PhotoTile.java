package org.dronewatch.render.photo;

import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.raster.TileTracer;

/** Exposes one tile of a picture after the other. For use by one thread. */
final class PhotoTile {
    private static final int NONE = -1;

    /** Rays into the hemisphere above the surface that a pixel shows, divided among its parts. */
    private static final int RAYS_PER_PIXEL = 32;

    private final PartGrid grid;
    private final SceneLight light;
    private final Surfaces site;
    private final int samples;
    private final Shading shading;
    private final TileTracer siteTracer;
    private final Map<KDTree, TileTracer> droneTracers = new IdentityHashMap<>();

    // The nearest surface of each part of each pixel: ray parameter, triangle, and number of the drone.
    private final double[] parameters = new double[TileTracer.WIDTH * TileTracer.HEIGHT];
    private final int[] triangles = new int[TileTracer.WIDTH * TileTracer.HEIGHT];
    private final int[] drones = new int[TileTracer.WIDTH * TileTracer.HEIGHT];

    private final double[] direction = new double[3];
    private final double[] normal = new double[3];
    private final double[] scratch = new double[3];
    private final double[] rgb = new double[Daylight.CHANNELS];
    private final double[] sum = new double[Daylight.CHANNELS];

    PhotoTile(PartGrid grid, SceneLight light, Surfaces site, int samples) {
        this.grid = grid;
        this.light = light;
        this.site = site;
        this.samples = samples;
        this.shading = new Shading(light, Math.max(2, RAYS_PER_PIXEL / (samples * samples)));
        this.siteTracer = new TileTracer(light.world().tree());
        siteTracer.setPicture(
                new double[] {grid.from().x(), grid.from().y(), grid.from().z()},
                grid.corner(),
                grid.right(),
                grid.down(),
                grid.near(),
                grid.far());
    }

    /**
     * Writes the pixels of a tile.
     *
     * @param layers drones that may appear in it
     * @param width width of the picture, pixels
     */
    void expose(
            int left,
            int top,
            int columns,
            int rows,
            List<DroneLayer> layers,
            Exposure exposure,
            int[] target,
            int width) {
        trace(left * samples, top * samples, columns * samples, rows * samples, layers);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                mean(left, top, column, row, columns * samples, layers);
                target[(top + row) * width + left + column] =
                        exposure.pixel(sum[0], sum[1], sum[2], left + column, top + row);
            }
        }
    }

    /** The mean radiance of a pixel of a tile that was traced. */
    private void mean(int left, int top, int column, int row, int rowLength, List<DroneLayer> layers) {
        Arrays.fill(sum, 0.0);
        for (int y = row * samples; y < (row + 1) * samples; y++) {
            for (int x = column * samples; x < (column + 1) * samples; x++) {
                shade(left * samples + x, top * samples + y, y * rowLength + x, layers);
                for (int i = 0; i < Daylight.CHANNELS; i++) {
                    sum[i] += rgb[i] / (samples * samples);
                }
            }
        }
    }

    /** The radiance of a pixel, with the drones that may appear in it. */
    double[] radiance(int column, int row, List<DroneLayer> layers) {
        trace(column * samples, row * samples, samples, samples, layers);
        mean(column, row, 0, 0, samples, layers);
        return sum.clone();
    }

    private void trace(int left, int top, int columns, int rows, List<DroneLayer> layers) {
        Arrays.fill(parameters, 0, columns * rows, Double.POSITIVE_INFINITY);
        Arrays.fill(triangles, 0, columns * rows, NONE);
        siteTracer.trace(left, top, columns, rows);
        keep(siteTracer, columns, rows, NONE);
        for (int i = 0; i < layers.size(); i++) {
            TileTracer tracer = tracer(layers.get(i));
            tracer.trace(left, top, columns, rows);
            keep(tracer, columns, rows, i);
        }
    }

    private TileTracer tracer(DroneLayer layer) {
        TileTracer tracer = droneTracers.computeIfAbsent(layer.drone().tree(), TileTracer::new);
        double[] from = new double[3];
        double[] corner = new double[3];
        double[] right = new double[3];
        double[] down = new double[3];
        layer.toModel(
                new double[] {grid.from().x(), grid.from().y(), grid.from().z()}, 1.0, from);
        layer.toModel(grid.corner(), 0.0, corner);
        layer.toModel(grid.right(), 0.0, right);
        layer.toModel(grid.down(), 0.0, down);
        tracer.setPicture(from, corner, right, down, grid.near(), grid.far());
        return tracer;
    }

    private void keep(TileTracer tracer, int columns, int rows, int drone) {
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int part = row * columns + column;
                if (tracer.hits(column, row) && tracer.parameter(column, row) < parameters[part]) {
                    parameters[part] = tracer.parameter(column, row);
                    triangles[part] = tracer.triangle(column, row);
                    drones[part] = drone;
                }
            }
        }
    }

    private void shade(int column, int row, int part, List<DroneLayer> layers) {
        double length = grid.direction(column, row, direction);
        if (triangles[part] == NONE) {
            light.backdrop(grid.from().z(), direction, rgb, scratch);
            return;
        }
        boolean ofSite = drones[part] == NONE;
        Surfaces surfaces = ofSite ? site : layers.get(drones[part]).surfaces();
        if (ofSite) {
            site.normal(triangles[part], normal);
        } else {
            layers.get(drones[part]).normal(triangles[part], scratch, normal);
        }
        shading.shade(
                grid.from(),
                direction,
                parameters[part] * length,
                normal,
                surfaces,
                triangles[part],
                row % samples * samples + column % samples,
                samples * samples,
                ofSite,
                rgb);
    }
}
