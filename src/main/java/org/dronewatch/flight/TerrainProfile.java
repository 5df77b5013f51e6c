package org.dronewatch.flight;

import java.util.OptionalDouble;
import org.dronewatch.world.Ground;

/**
 * The profile of the ground below a ground track, raised so that it is nowhere too steep: heights at the nodes that
 * divide the track into short segments.
 */
public final class TerrainProfile {
    private TerrainProfile() {}

    /**
     * The lowest profile above the ground that is nowhere steeper than allowed.
     *
     * @param slope maximum slope, metres up or down for each metre along the track
     * @return the height of the profile at each node of the track, m
     * @throws IllegalArgumentException when there is no surface anywhere below the track
     */
    public static double[] over(GroundTrack track, Ground ground, double slope) {
        double[] heights = covering(track, known(track, ground), slope);
        for (int i = 1; i < heights.length; i++) {
            double fall = slope * (track.along(i) - track.along(i - 1));
            heights[i] = Math.max(heights[i], heights[i - 1] - fall);
        }
        for (int i = heights.length - 1; i > 0; i--) {
            double fall = slope * (track.along(i) - track.along(i - 1));
            heights[i - 1] = Math.max(heights[i - 1], heights[i] - fall);
        }
        return heights;
    }

    /** The height of the ground at each node; where there is none, the height at the nearest node that has ground. */
    private static double[] known(GroundTrack track, Ground ground) {
        double[] heights = new double[track.size()];
        // The last node so far that has ground, and the first node after it that has none.
        int before = -1;
        for (int i = 0; i < heights.length; i++) {
            OptionalDouble height = ground.height(track.x(i), track.y(i));
            if (height.isPresent()) {
                heights[i] = height.getAsDouble();
                fill(heights, track, before, i);
                before = i;
            }
        }
        if (before < 0) {
            throw new IllegalArgumentException("there is no ground anywhere below the path of "
                    + (float) track.along(heights.length - 1) + " m for the drone to follow");
        }
        fill(heights, track, before, heights.length);
        return heights;
    }

    /** Fills the gap between two nodes that have ground; -1 and the track's size mean none. */
    private static void fill(double[] heights, GroundTrack track, int before, int after) {
        for (int i = before + 1; i < after; i++) {
            boolean earlier = after == heights.length
                    || before >= 0 && track.along(i) - track.along(before) <= track.along(after) - track.along(i);
            heights[i] = heights[earlier ? before : after];
        }
    }

    /**
     * Heights at the nodes such that straight segments between them also clear the ground in between. A ridge between
     * two nodes is assumed to be no higher than the intersection of the extrapolated slopes on either side; slopes
     * steeper than the limit (walls) are extrapolated at the limit.
     */
    private static double[] covering(GroundTrack track, double[] ground, double slope) {
        double[] heights = ground.clone();
        for (int i = 1; i < ground.length; i++) {
            double highest = Math.max(ground[i - 1], ground[i]);
            if (i > 1 && i < ground.length - 1) {
                double most = slope * (track.along(i) - track.along(i - 1));
                double left = Math.min(ground[i - 1] - ground[i - 2], most);
                double right = Math.min(ground[i] - ground[i + 1], most);
                highest = Math.max(highest, Math.min(ground[i - 1] + left, ground[i] + right));
            }
            heights[i - 1] = Math.max(heights[i - 1], highest);
            heights[i] = Math.max(heights[i], highest);
        }
        return heights;
    }
}
