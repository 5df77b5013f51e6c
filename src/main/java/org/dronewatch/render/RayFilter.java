package org.dronewatch.render;

import java.util.stream.IntStream;

/**
 * A filter for the segments of rays to be drawn.
 *
 * @param fewest minimum reflection order: the number of surfaces that the ray has met before the segment
 * @param most maximum reflection order
 * @param heardOnly whether to show only segments of paths that reached the sensor
 */
public record RayFilter(int fewest, int most, boolean heardOnly) {
    /** A filter that passes all segments. */
    public static final RayFilter ALL = new RayFilter(0, Integer.MAX_VALUE, false);

    /** Whether a segment is drawn. */
    public boolean shows(RecordedRays rays, int piece) {
        int order = rays.order(piece);
        return order >= fewest && order <= most && (!heardOnly || rays.isHeard(piece));
    }

    /** The indices of the segments to draw; evenly thinned out if there are more than a maximum number. */
    int[] pieces(RecordedRays rays, int most) {
        int[] all = IntStream.range(0, rays.count())
                .filter(piece -> shows(rays, piece))
                .toArray();
        if (all.length <= most) {
            return all;
        }
        return IntStream.range(0, most)
                .map(i -> all[(int) ((long) i * all.length / most)])
                .toArray();
    }

    /** The number of segments that this filter passes. */
    public int count(RecordedRays rays) {
        int shown = 0;
        for (int i = 0; i < rays.count(); i++) {
            shown += shows(rays, i) ? 1 : 0;
        }
        return shown;
    }
}
