package org.dronewatch.sensor.optics;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.Stream;
import org.dronewatch.world.SiteMemory;

/**
 * The distances of a site in the image of one camera, kept in tiles, as far as they have been traced. Cameras on
 * several threads may share it: the first thread that needs a tile traces it, holding a lock, so that no other thread
 * traces it too. Thread-safe.
 */
final class SiteImage implements SiteMemory.Kept {
    private static final int LOCKS = 64;

    private final Object[] locks = Stream.generate(Object::new).limit(LOCKS).toArray();
    private final AtomicReferenceArray<float[]> tiles;
    private final AtomicLong pixels = new AtomicLong();

    /**
     * An image of which nothing has been traced.
     *
     * @param count number of tiles of the image
     */
    SiteImage(int count) {
        this.tiles = new AtomicReferenceArray<>(count);
    }

    /** The number of tiles. */
    int tiles() {
        return tiles.length();
    }

    /**
     * The distances in a tile, m, row by row, infinity where the site is not in view; null for a tile that has not been
     * traced yet.
     */
    float[] tile(int number) {
        return tiles.get(number);
    }

    /** Keeps a tile that has been traced. */
    void put(int number, float[] distances) {
        if (tiles.getAndSet(number, distances) == null) {
            pixels.addAndGet(distances.length);
        }
    }

    @Override
    public long bytes() {
        return Float.BYTES * pixels.get();
    }

    /** The lock to hold while a part of the image, given by its number, is traced. */
    Object lock(int part) {
        return locks[part % LOCKS];
    }
}
