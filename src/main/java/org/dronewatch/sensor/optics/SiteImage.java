package org.dronewatch.sensor.optics;

import java.util.concurrent.atomic.AtomicReferenceArray;
import org.dronewatch.world.World;

/**
 * The image of a world from one camera, tile by tile as far as it has been traced. Cameras on several threads may share
 * it: whoever needs a tile first traces it, and two that need it at once trace the same. Thread-safe.
 */
final class SiteImage {
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
}
