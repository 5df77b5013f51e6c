package org.dronewatch.report.sheet;

import java.awt.Color;

/** Mixes colours, for cells that let the ground show through, and for shades of one colour. */
public final class ColourMix {
    private ColourMix() {}

    /**
     * A colour mixed with another that lies over it.
     *
     * @param share fraction of the colour above, 0 to 1
     */
    public static Color of(Color below, Color above, double share) {
        return new Color(
                (int) Math.round((1 - share) * below.getRed() + share * above.getRed()),
                (int) Math.round((1 - share) * below.getGreen() + share * above.getGreen()),
                (int) Math.round((1 - share) * below.getBlue() + share * above.getBlue()));
    }

    /**
     * A pixel mixed with a colour that lies over it: red, green and blue in the lowest 24 bits.
     *
     * @param below the pixel, in the same form
     * @param share fraction of the colour above, 0 to 1
     */
    public static int of(int below, Color above, double share) {
        return of(below, above.getRGB(), share);
    }

    /** A pixel mixed with another that lies over it: red, green and blue in the lowest 24 bits. */
    static int of(int below, int above, double share) {
        return part(below, above, share, 16) | part(below, above, share, 8) | part(below, above, share, 0);
    }

    private static int part(int below, int above, double share, int shift) {
        double mixed = (1 - share) * (below >> shift & 0xff) + share * (above >> shift & 0xff);
        return (int) (mixed + 0.5) << shift;
    }
}
