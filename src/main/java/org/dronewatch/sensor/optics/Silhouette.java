package org.dronewatch.sensor.optics;

import java.util.Arrays;

/**
 * The pixels of one drone in a frame, within its rectangle. Kept from frame to frame. For use by one thread at a time.
 */
final class Silhouette {
    private final PixelRectangle rectangle = new PixelRectangle();

    /** Distance of the drone in each pixel of the rectangle, row by row, m; infinity where it is not seen. */
    private float[] distances = new float[0];

    private int pixels;

    /** The pixels that may show the drone; set this rectangle, then call {@link #clear()}. */
    PixelRectangle rectangle() {
        return rectangle;
    }

    /** Forgets all pixels. */
    void clear() {
        pixels = 0;
        if (distances.length < rectangle.pixels()) {
            distances = new float[rectangle.pixels()];
        }
        Arrays.fill(distances, 0, rectangle.pixels(), Float.POSITIVE_INFINITY);
    }

    /** Whether two drones may overlap in the image. */
    boolean overlaps(Silhouette other) {
        PixelRectangle theirs = other.rectangle;
        return rectangle.left() <= theirs.right()
                && theirs.left() <= rectangle.right()
                && rectangle.top() <= theirs.bottom()
                && theirs.top() <= rectangle.bottom();
    }

    /** The distance of the drone in a pixel, m; infinity where it is not seen. */
    float distance(int column, int row) {
        return rectangle.contains(column, row) ? distances[index(column, row)] : Float.POSITIVE_INFINITY;
    }

    /** Records that a pixel of the rectangle shows the drone. */
    void show(int column, int row, float distance) {
        distances[index(column, row)] = distance;
        pixels++;
    }

    /** Records that a pixel that showed the drone no longer does. */
    void hide(int column, int row) {
        distances[index(column, row)] = Float.POSITIVE_INFINITY;
        pixels--;
    }

    private int index(int column, int row) {
        return (row - rectangle.top()) * (rectangle.right() - rectangle.left() + 1) + column - rectangle.left();
    }

    /** The number of pixels that show the drone. */
    int pixels() {
        return pixels;
    }
}
