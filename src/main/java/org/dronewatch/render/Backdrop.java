package org.dronewatch.render;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.canvas.Canvas;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.sensor.optics.CameraObject;

/** An image of the site alone, without sensors and drones, from one viewpoint. Immutable. */
public final class Backdrop {
    private final Orbit orbit;
    private final int width;
    private final int height;
    private final Optional<Cut> cut;
    private final Fineness fineness;
    private final CameraObject camera;
    private final Canvas canvas;

    Backdrop(
            Orbit orbit,
            int width,
            int height,
            Optional<Cut> cut,
            Fineness fineness,
            CameraObject camera,
            Canvas canvas) {
        this.orbit = orbit;
        this.width = width;
        this.height = height;
        this.cut = cut;
        this.fineness = fineness;
        this.camera = camera;
        this.canvas = canvas;
    }

    /** The viewpoint. */
    public Orbit orbit() {
        return orbit;
    }

    /** Columns of the image. */
    public int width() {
        return width;
    }

    /** Rows of the image. */
    public int height() {
        return height;
    }

    /** The part of the site that is cut away. */
    public Optional<Cut> cut() {
        return cut;
    }

    /** The resolution of the image. */
    public Fineness fineness() {
        return fineness;
    }

    /** The point of the world shown by a pixel, m; empty for the sky and outside the image. */
    public Optional<Position> placeAt(int column, int row) {
        if (column < 0 || row < 0 || column >= width || row >= height) {
            return Optional.empty();
        }
        int x = Math.min(canvas.width - 1, column * canvas.width / width);
        int y = Math.min(canvas.height - 1, row * canvas.height / height);
        float depth = canvas.depth[y * canvas.width + x];
        if (depth == Float.POSITIVE_INFINITY) {
            return Optional.empty();
        }
        double[] d = new double[3];
        camera.direction(x, y, d);
        double along = depth * camera.obliqueness(x, y);
        return Optional.of(camera.position().plus(new Position(d[0], d[1], d[2]).times(along)));
    }

    /**
     * This backdrop with one depth per pixel: faster to copy for each picture, but lines drawn over it have no soft
     * edges.
     */
    public Backdrop flat() {
        if (canvas.width <= width) {
            return this;
        }
        return new Backdrop(
                orbit, width, height, cut, fineness, orbit.camera(width, height), canvas.shrunk(width, height));
    }

    /** This view with other colours. */
    Backdrop withCanvas(Canvas other) {
        return new Backdrop(orbit, width, height, cut, fineness, camera, other);
    }

    CameraObject camera() {
        return camera;
    }

    Canvas canvas() {
        return canvas;
    }
}
