package org.dronewatch.render;

import java.util.Map;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.raster.TileTracer;
import org.dronewatch.render.canvas.Canvas;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.ModelGrid;
import org.jogamp.vecmath.Matrix4d;

/** Paints a drone into a canvas where it is in front of what is already there. */
final class DronePainter {
    private final Drone drone;
    private final int colour;
    private final Facets facets;
    private final Matrix4d toWorld;

    DronePainter(Drone drone, int colour) {
        this.drone = drone;
        this.colour = colour;
        this.facets = new Facets(drone.tree().mesh(), Map.of());
        this.toWorld = drone.modelMatrix();
    }

    void paint(CameraObject camera, Canvas canvas) {
        Position at = drone.origin();
        double reach = drone.radius();
        if (camera.isOutside(at.x(), at.y(), at.z(), reach)) {
            return;
        }
        double[] view = new double[3];
        camera.toView(at.x(), at.y(), at.z(), view, 0);
        double near = Math.max(CameraObject.NEAR, view[2] - reach);
        double radius = camera.focalLength() * reach / near + 1.0;
        double column = 0.5 * camera.width() + camera.focalLength() * view[0] / near;
        double row = 0.5 * camera.height() - camera.focalLength() * view[1] / near;
        double aside = Math.abs(column - (0.5 * camera.width() + camera.focalLength() * view[0] / (view[2] + reach)));
        double above = Math.abs(row - (0.5 * camera.height() - camera.focalLength() * view[1] / (view[2] + reach)));
        paint(
                camera,
                canvas,
                (int) Math.max(0.0, column - radius - aside),
                (int) Math.max(0.0, row - radius - above),
                (int) Math.min(canvas.width, column + radius + aside + 1.0),
                (int) Math.min(canvas.height, row + radius + above + 1.0));
    }

    private void paint(CameraObject camera, Canvas canvas, int left, int top, int right, int bottom) {
        TileTracer tiles = new TileTracer(drone.tree());
        new ModelGrid(camera).setPicture(tiles, drone.worldToModel());
        double[] direction = new double[3];
        for (int y = top; y < bottom; y += TileTracer.HEIGHT) {
            for (int x = left; x < right; x += TileTracer.WIDTH) {
                int columns = Math.min(TileTracer.WIDTH, right - x);
                int rows = Math.min(TileTracer.HEIGHT, bottom - y);
                tiles.trace(x, y, columns, rows);
                for (int i = 0; i < columns * rows; i++) {
                    int column = i % columns;
                    int row = i / columns;
                    int pixel = (y + row) * canvas.width + x + column;
                    if (tiles.hits(column, row) && tiles.parameter(column, row) < canvas.depth[pixel]) {
                        camera.direction(x + column, y + row, direction);
                        canvas.depth[pixel] = (float) tiles.parameter(column, row);
                        canvas.rgb[pixel] = shade(tiles.triangle(column, row), direction);
                    }
                }
            }
        }
    }

    private int shade(int triangle, double[] d) {
        double u = facets.normal(triangle, 0);
        double v = facets.normal(triangle, 1);
        double w = facets.normal(triangle, 2);
        double x = toWorld.m00 * u + toWorld.m01 * v + toWorld.m02 * w;
        double y = toWorld.m10 * u + toWorld.m11 * v + toWorld.m12 * w;
        double z = toWorld.m20 * u + toWorld.m21 * v + toWorld.m22 * w;
        double scale = 1.0 / Math.sqrt(x * x + y * y + z * z);
        return DaylightShading.shade(colour, scale * x, scale * y, scale * z, d[0], d[1], d[2], 1.0);
    }
}
