package org.dronewatch.render;

import org.dronewatch.render.canvas.Canvas;

/**
 * A colour scale for sound levels, from violet for low levels to red for high ones. Changes of level are also visible
 * to colour-blind readers, because lightness varies at both ends.
 *
 * @param low the lowest level that has a distinct colour, dB
 * @param high the highest level that has a distinct colour, dB
 */
public record LevelScale(double low, double high) {
    private static final int[] COLOURS = {0x3b2f8f, 0x2f6fd0, 0x2fb3c8, 0x6fce6a, 0xe6d93c, 0xf59a23, 0xe03a1e, 0x98103a
    };

    /** Checks the order. */
    public LevelScale {
        if (!(low < high)) {
            throw new IllegalArgumentException("low " + low + " dB must be below high " + high + " dB");
        }
    }

    /** The scale for some levels, dB, with limits that are multiples of 5 dB. */
    static LevelScale of(float[] levels) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (float level : levels) {
            if (Float.isFinite(level)) {
                low = Math.min(low, level);
                high = Math.max(high, level);
            }
        }
        if (!(low <= high)) {
            return new LevelScale(0.0, 60.0);
        }
        double top = 5.0 * Math.ceil(high / 5.0);
        // Levels more than 60 dB below the loudest are not distinguished.
        double bottom = Math.max(top - 60.0, 5.0 * Math.floor(low / 5.0));
        return new LevelScale(Math.min(bottom, top - 5.0), top);
    }

    /**
     * The colour of a level in dB: red, green and blue in the lowest 24 bits. Levels beyond the scale have the colour
     * of its nearer end.
     */
    public int colour(double level) {
        double share = Math.max(0.0, Math.min(1.0, (level - low) / (high - low)));
        double index = share * (COLOURS.length - 1);
        int below = (int) Math.min(COLOURS.length - 2.0, index);
        return Canvas.mix(COLOURS[below], COLOURS[below + 1], index - below);
    }
}
