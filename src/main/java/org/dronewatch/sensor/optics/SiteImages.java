package org.dronewatch.sensor.optics;

import org.dronewatch.world.World;

/**
 * The image of a camera in the last world that it was in: views of the same camera on several threads share it, and
 * those of a camera at rest also with other runs, where their worlds have a memory. Thread-safe.
 */
final class SiteImages {
    private final CameraObject camera;
    private final boolean atRest;
    private World world;
    private SiteImage image;

    /**
     * A collection without images.
     *
     * @param atRest whether other runs are likely to have a camera of the same pose
     */
    SiteImages(CameraObject camera, boolean atRest) {
        this.camera = camera;
        this.atRest = atRest;
    }

    /**
     * The image of a world; that of another one is forgotten.
     *
     * @param tiles their number
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
