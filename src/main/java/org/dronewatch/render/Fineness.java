package org.dronewatch.render;

/** How finely a site is painted: less while it moves, more at rest. */
public enum Fineness {
    /** A ray for sixteen pixels, and not all rays of sound. */
    COARSE(1, 4, false, 10_000),
    /** A ray for four pixels, and not all rays of sound. */
    DRAFT(1, 2, false, 20_000),
    /** Every pixel. */
    PLAIN(1, 1, false, Integer.MAX_VALUE),
    /** Four rays a pixel, with the sun's shadows. */
    FINE(2, 1, true, Integer.MAX_VALUE);

    /** Rays along a side of a block of pixels. */
    final int rays;
    /** Pixels along a side of such a block. */
    final int pixels;

    final boolean shadows;
    /** The most segments of sound rays that are drawn. */
    final int pieces;

    Fineness(int rays, int pixels, boolean shadows, int pieces) {
        this.rays = rays;
        this.pixels = pixels;
        this.shadows = shadows;
        this.pieces = pieces;
    }

    /** Rays along a line of a number of pixels. */
    public int raysIn(int length) {
        return Math.max(1, length * rays / pixels);
    }
}
