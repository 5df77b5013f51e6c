package org.dronewatch.drone;

/**
 * What a level drone certainly covers, and what it certainly does not, when it is seen from any of a range of
 * directions: a grid of square texels around its origin, in the plane across the line of sight. The grid's first
 * texel is at the left and at the bottom. Immutable.
 */
public final class SilhouetteMask {
    /** Texels along a side. */
    public static final int TEXELS = 128;

    /** A texel no point of which is covered. */
    public static final byte OUTSIDE = 0;

    /** A texel that may be covered or not, or in part; seen from the middle of the directions, its centre is not. */
    public static final byte UNLIKELY = 1;

    /** A texel that may be covered or not, or in part; seen from the middle of the directions, its centre is. */
    public static final byte LIKELY = 2;

    /** A texel all of whose points are covered. */
    public static final byte INSIDE = 3;

    private final byte[] kinds;

    /** A mask of texels, row by row; the array is not copied. */
    SilhouetteMask(byte[] kinds) {
        this.kinds = kinds;
    }

    /**
     * Whether a texel is {@link #OUTSIDE}, {@link #UNLIKELY}, {@link #LIKELY} or {@link #INSIDE}; texels are numbered
     * row by row.
     */
    public byte kind(int texel) {
        return kinds[texel];
    }
}
