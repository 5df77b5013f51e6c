package org.dronewatch.report.sheet;

import java.awt.Color;

/** A colour that is laid over others with constant opacity, mixed in advance, for animated pictures. */
public final class Tint {
    private static final int LEVELS = 256;

    /** For each level of red, green or blue below, the level that is seen, shifted to its position in a pixel. */
    private final int[] red = new int[LEVELS];

    private final int[] green = new int[LEVELS];
    private final int[] blue = new int[LEVELS];

    /**
     * A tint.
     *
     * @param share fraction of the colour above, 0 to 1, as for {@link ColourMix}
     */
    public Tint(Color above, double share) {
        for (int level = 0; level < LEVELS; level++) {
            int mixed = ColourMix.of(level << 16 | level << 8 | level, above, share);
            red[level] = mixed & 0xff0000;
            green[level] = mixed & 0x00ff00;
            blue[level] = mixed & 0x0000ff;
        }
    }

    /** The colour of a pixel with this tint over it: red, green and blue in the lowest 24 bits. */
    public int over(int below) {
        return red[below >> 16 & 0xff] | green[below >> 8 & 0xff] | blue[below & 0xff];
    }
}
