package org.dronewatch.render;

/** The resolution at which a site is painted: coarse while the view moves, fine at rest. */
public enum Fineness {
    /** One ray per sixteen pixels; not all sound rays are drawn. */
    COARSE(1, 4, false, 10_000),
    /** One ray per four pixels; not all sound rays are drawn. */
    DRAFT(1, 2, false, 20_000),
    /** One ray per pixel. */
    PLAIN(1, 1, false, Integer.MAX_VALUE),
    /** Four rays per pixel, with shadows cast in sunlight. */
    FINE(2, 1, true, Integer.MAX_VALUE);

    /** Rays along a side of a block of pixels. */
    final int rays;
    /** Pixels along a side of a block of pixels. */
    final int pixels;

    final boolean shadows;
    /** Maximum number of sound-ray segments drawn. */
    final int pieces;

    Fineness(int rays, int pixels, boolean shadows, int pieces) {
        this.rays = rays;
        this.pixels = pixels;
        this.shadows = shadows;
        this.pieces = pieces;
    }

    /** The number of rays along a line of a given number of pixels. */
    public int raysIn(int length) {
        return Math.max(1, length * rays / pixels);
    }
}
