package org.dronewatch.sensor.optics;

/**
 * A rectangle of pixels, which includes its first and last row and column; set anew in each frame. For use by one
 * thread at a time.
 */
final class PixelRectangle {
    private int left;
    private int top;
    private int right = -1;
    private int bottom = -1;

    /** Makes the rectangle empty. */
    void clear() {
        set(0, 0, -1, -1);
    }

    /** Sets the first and last column and row. */
    void set(int newLeft, int newTop, int newRight, int newBottom) {
        left = newLeft;
        top = newTop;
        right = newRight;
        bottom = newBottom;
    }

    int left() {
        return left;
    }

    int top() {
        return top;
    }

    int right() {
        return right;
    }

    int bottom() {
        return bottom;
    }

    /** The number of its pixels. */
    int pixels() {
        return isEmpty() ? 0 : (right - left + 1) * (bottom - top + 1);
    }

    boolean contains(int column, int row) {
        return column >= left && column <= right && row >= top && row <= bottom;
    }

    boolean isEmpty() {
        return right < left || bottom < top;
    }

    /** Whether something is nearer than a distance, m, along the rays of all its pixels. */
    boolean isHidden(Background site, double distance) {
        for (int row = top; row <= bottom; row++) {
            for (int column = left; column <= right; column++) {
                if (!(site.distance(column, row) < distance)) {
                    return false;
                }
            }
        }
        return true;
    }
}
