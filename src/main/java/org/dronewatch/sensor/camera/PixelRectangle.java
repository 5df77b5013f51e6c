package org.dronewatch.sensor.camera;

/**
 * A rectangle of pixels, borders included; empty when the right is left of the left.
 *
 * @param left first column
 * @param top first row
 * @param right last column
 * @param bottom last row
 */
record PixelRectangle(int left, int top, int right, int bottom) {
    /** No pixel at all. */
    static final PixelRectangle EMPTY = new PixelRectangle(0, 0, -1, -1);

    /** How many pixels it has. */
    int pixels() {
        return isEmpty() ? 0 : (right - left + 1) * (bottom - top + 1);
    }

    boolean isEmpty() {
        return right < left || bottom < top;
    }
}
