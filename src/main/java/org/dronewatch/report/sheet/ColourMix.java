package org.dronewatch.report.sheet;

import java.awt.Color;

/** Mixes colours, for cells that let the ground show through, and for shades of one colour. */
public final class ColourMix {
    private ColourMix() {}

    /**
     * A colour mixed with another that lies over it.
     *
     * @param share of the colour above, 0 to 1
     */
    public static Color of(Color below, Color above, double share) {
        return new Color(
                (int) Math.round((1 - share) * below.getRed() + share * above.getRed()),
                (int) Math.round((1 - share) * below.getGreen() + share * above.getGreen()),
                (int) Math.round((1 - share) * below.getBlue() + share * above.getBlue()));
    }
}
