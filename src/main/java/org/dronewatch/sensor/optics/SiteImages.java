package org.dronewatch.sensor.optics;

import org.dronewatch.world.World;

/**
 * The image that a camera takes of the most recent world. Views of the same camera on several threads share this image;
 * views of a camera at rest also share it with other runs, if the worlds of these runs share a cache. Thread-safe.
 */
final class SiteImages {
    private final CameraObject camera;
    private final boolean atRest;
    private World world;
    private SiteImage image;

    /**
     * A holder without an image.
     *
     * @param atRest whether other runs are likely to have a camera in the same pose
     */
    SiteImages(CameraObject camera, boolean atRest) {
        this.camera = camera;
        this.atRest = atRest;
    }

    /**
     * The image of a world; the image of any other world is forgotten.
     *
     * @param tiles number of tiles of the image
     */
    synchronized SiteImage of(World site, int tiles) {
        if (world != site) {
            world = site;
            image = atRest
                    ? site.remembered(camera.pose(), SiteImage.class, () -> new SiteImage(tiles))
                    : new SiteImage(tiles);
        }
        return image;
    }
}
