package org.dronewatch.raster;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Counts the pixels of large models that are rasterised before the just-in-time compiler has warmed up. After
 * {@link #PIXELS} pixels, the rasterisers that use the counter switch to the processor's vector instructions, where
 * these can be used ({@code --add-modules jdk.incubator.vector}). The pixels are the same before and after, bit for
 * bit; only the speed differs.
 *
 * <p>The compiler needs about 0.3 s before vector instructions pay off; in this time the scalar code draws
 * {@link #PIXELS} pixels, so short jobs, such as a few images, never incur the warm-up cost. Compiled code is per
 * process, so rasterisers use the counter of the process ({@link #OF_PROCESS}) unless they are given another, such as a
 * new one to measure or test either state. Shared by all threads.
 */
public final class RasterWarmup {
    /** The number of pixels of large models that are drawn without vector instructions. */
    public static final long PIXELS = 8_000_000;

    /** The counter that all rasterisers of this process use unless they are given another. */
    public static final RasterWarmup OF_PROCESS = new RasterWarmup();

    private final AtomicLong pixels = new AtomicLong();

    /** A counter that begins at zero. */
    public RasterWarmup() {}

    /** Whether enough pixels have been drawn for vector instructions to pay off. */
    public boolean isOver() {
        return pixels.get() > PIXELS;
    }

    /**
     * Counts pixels that are about to be drawn.
     *
     * @return whether the warm-up is over now
     */
    boolean add(long more) {
        return pixels.addAndGet(more) > PIXELS;
    }
}
