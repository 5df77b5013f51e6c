package org.dronewatch.terrain;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.setting.Counted;

/** Checks heights as they were read: implausible ones become holes, and the rest are counted. */
final class Heights {
    /** Below the deepest trench and above the highest mountain, m. */
    private static final float LOWEST = -11_000.0F;

    private static final float HIGHEST = 9_000.0F;
    private static final float USUAL_NODATA = -9999.0F;
    private static final double MANY = 0.01;

    private final float[] heights;
    private int holes;
    private int stated;
    private int impossible;
    private int zeros;
    private float lowest = Float.POSITIVE_INFINITY;
    private float highest = Float.NEGATIVE_INFINITY;

    /**
     * Checks heights, and replaces those that mean "no data" or cannot be heights by NaN.
     *
     * @param nodata a height that means "no data"
     */
    Heights(float[] heights, Optional<Double> nodata) {
        this.heights = heights;
        float none = nodata.map(Double::floatValue).orElse(Float.NaN);
        for (int i = 0; i < heights.length; i++) {
            float height = heights[i];
            if (height == none) {
                stated++;
                heights[i] = Float.NaN;
            } else if (!Float.isNaN(height) && !(height > LOWEST && height < HIGHEST && height != USUAL_NODATA)) {
                impossible++;
                heights[i] = Float.NaN;
            }
            count(heights[i]);
        }
    }

    private void count(float height) {
        if (Float.isNaN(height)) {
            holes++;
            return;
        }
        zeros += height == 0.0F ? 1 : 0;
        lowest = Math.min(lowest, height);
        highest = Math.max(highest, height);
    }

    int holes() {
        return holes;
    }

    int known() {
        return heights.length - holes;
    }

    float lowest() {
        return lowest;
    }

    float highest() {
        return highest;
    }

    /**
     * Adds lines about heights that look odd.
     *
     * @param statesNodata whether the files state a height that means "no data"
     */
    void warn(List<String> warnings, boolean statesNodata) {
        if (impossible > 0) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "terrain: %s (%.0f, or not between %.0f and %.0f m): %s",
                    Counted.of(impossible, "post has an impossible height", "posts have impossible heights"),
                    USUAL_NODATA,
                    LOWEST,
                    HIGHEST,
                    impossible == 1 ? "it is treated as a hole" : "they are treated as holes"));
        }
        if (!statesNodata && zeros > MANY * heights.length && zeros < heights.length) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "terrain: %,d of %,d posts are exactly 0 m high: if that is not the sea, world.terrain.nodata: 0 turns them"
                            + " into holes",
                    zeros,
                    heights.length));
        }
    }
}
