package org.dronewatch.picture;

/** How finely a site is painted: less while it moves, more at rest. */
public enum Fineness {
    /** A quarter of the pixels. */
    DRAFT(1, 2, false),
    /** Every pixel. */
    PLAIN(1, 1, false),
    /** Four rays a pixel, with the sun's shadows. */
    FINE(2, 1, true);

    /** Rays along a side of a block of pixels. */
    final int rays;
    /** Pixels along a side of such a block. */
    final int pixels;

    final boolean shadows;

    Fineness(int rays, int pixels, boolean shadows) {
        this.rays = rays;
        this.pixels = pixels;
        this.shadows = shadows;
    }

    /** Rays along a line of so many pixels. */
    int raysIn(int length) {
        return Math.max(1, length * rays / pixels);
    }
}
