package org.dronewatch.render.film;

import java.util.Locale;

/**
 * The times of a run shown in a video.
 *
 * @param from simulated time of its first frame, 0 or more, s
 * @param to simulated time at which it ends, not before {@code from}, s
 * @param fps frames per second, {@value #LEAST_FPS} to {@value #MOST_FPS}
 * @param speed playback speed as a multiple of real time, 0.01 to 1000
 */
public record Film(double from, double to, int fps, double speed) {
    /** Minimum number of frames per second. */
    public static final int LEAST_FPS = 1;

    /** Maximum number of frames per second. */
    public static final int MOST_FPS = 60;

    /** Maximum number of frames of a video: 24 minutes at 25 frames per second. */
    public static final int MOST_FRAMES = 36_000;

    /** The longest side of a frame that players decode, pixels. */
    public static final int LONGEST_SIDE = 4096;

    private static final double SLOWEST = 0.01;
    private static final double FASTEST = 1000.0;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException naming the value and its limit
     */
    public Film {
        if (!(from >= 0.0 && from <= to && to < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "a video from " + from + " s to " + to + " s: must not end before it begins");
        }
        if (fps < LEAST_FPS || fps > MOST_FPS) {
            throw new IllegalArgumentException(
                    "fps " + fps + ": must be " + LEAST_FPS + " to " + MOST_FPS + " frames per second");
        }
        if (!(speed >= SLOWEST && speed <= FASTEST)) {
            throw new IllegalArgumentException("speed " + speed + ": must be " + SLOWEST + " to " + (int) FASTEST);
        }
        double frames = Math.floor((to - from) * fps / speed) + 1.0;
        if (frames > MOST_FRAMES) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "a video of %.0f frames: there must be at most %d; show less of the run, or play it faster",
                    frames,
                    MOST_FRAMES));
        }
    }

    /**
     * Checks the size of frames, pixels.
     *
     * @throws IllegalArgumentException when a side is longer than {@link #LONGEST_SIDE}
     */
    public static void checkSize(int width, int height) {
        if (width > LONGEST_SIDE || height > LONGEST_SIDE) {
            throw new IllegalArgumentException(
                    "a video of " + width + " x " + height + " pixels: each side must be at most " + LONGEST_SIDE);
        }
    }

    /** The number of its frames, at least 1. */
    public int frames() {
        return (int) Math.floor((to - from) * fps / speed + 1e-9) + 1;
    }

    /**
     * Simulated time that a frame shows, s.
     *
     * @param frame index of the frame, from 0
     */
    public double time(int frame) {
        // From the index: adding up intervals drifts.
        return Math.min(to, from + frame * speed / fps);
    }
}
