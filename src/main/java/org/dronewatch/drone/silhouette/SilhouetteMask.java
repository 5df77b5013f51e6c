package org.dronewatch.drone.silhouette;

import java.util.Arrays;

/**
 * The area that a level drone certainly covers, and the area that it certainly does not cover, as seen from any
 * direction within a small range of directions: a grid of square texels around the drone's origin, in the plane
 * perpendicular to the line of sight. The first texel is at the bottom left. Immutable.
 */
public final class SilhouetteMask {
    /** The number of texels along a side. */
    public static final int TEXELS = 128;

    /** A texel that is not covered at all. */
    public static final byte OUTSIDE = 0;

    /**
     * A texel that may be covered in full, in part, or not at all; seen from the middle of the range, its centre is not
     * covered.
     */
    public static final byte UNLIKELY = 1;

    /**
     * A texel that may be covered in full, in part, or not at all; seen from the middle of the range, its centre is
     * covered.
     */
    public static final byte LIKELY = 2;

    /** A texel that is covered in full. */
    public static final byte INSIDE = 3;

    private final byte[] kinds;

    /** The kinds that were looked up last for a whole list of texels; null if there are none. */
    private volatile Selection selection;

    /** The kinds of a list of texels, which is the same array for all masks. */
    private record Selection(int[] texels, byte[] kinds) {}

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

    /**
     * Copies the kinds of a list of texels. They are kept until the kinds of another list are requested: a list is far
     * smaller than a mask, and so remains in the processor's caches where masks do not.
     *
     * @param texels numbers of texels, or a negative number for a point that is outside the mask; must not be changed
     *     afterwards
     * @param target receives the kinds, in the same order; {@link #OUTSIDE} for points outside the mask
     */
    public void copyKinds(int[] texels, byte[] target) {
        Selection known = selection;
        if (known == null || !Arrays.equals(known.texels, texels)) {
            known = new Selection(texels, select(texels));
            selection = known;
        }
        System.arraycopy(known.kinds, 0, target, 0, known.kinds.length);
    }

    private byte[] select(int[] texels) {
        byte[] selected = new byte[texels.length];
        for (int i = 0; i < texels.length; i++) {
            selected[i] = texels[i] < 0 ? OUTSIDE : kinds[texels[i]];
        }
        return selected;
    }
}
