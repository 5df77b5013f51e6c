package org.dronewatch.sensor.optics;

import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.Stream;
import org.dronewatch.world.World;

/**
 * The image of a world from one camera, tile by tile as far as it has been traced. Cameras on several threads may share
 * it: whoever needs a tile first traces it, holding a lock, so that no other traces the same. Thread-safe.
 */
final class SiteImage {
    private static final int LOCKS = 64;

    private final Object[] locks = Stream.generate(Object::new).limit(LOCKS).toArray();
    private World world;
    private AtomicReferenceArray<float[]> tiles;

    /**
     * The tiles of a world, each null until it has been traced; those of another world are forgotten.
     *
     * @param count number of tiles of the camera
     */
    synchronized AtomicReferenceArray<float[]> of(World site, int count) {
        if (world != site) {
            world = site;
            tiles = new AtomicReferenceArray<>(count);
        }
        return tiles;
    }

    /** What to hold while a part of the image is traced, given by its number. */
    Object lock(int part) {
        return locks[part % LOCKS];
    }
}
